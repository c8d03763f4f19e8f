#!/bin/sh
# A mask of bool that tifffile 2023.2.3 (Debian 12) writes is its own complement for Pillow 9.4.0: tifffile stores True as 1 with
# PhotometricInterpretation 0 (white is zero) unless `photometric` is given, and gives the stored bits back; Pillow, like VTK, reads white
# as True. Masks of Pillow (1, black is zero) are read alike by both. So of the same mask the background is the shape, without a word.
set -eu
tifffile=20230203-1
pillow=9.4.0-1.1+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-tifffile=$tifffile" "python3-pil=$pillow" libimagequant0 liblcms2-2 libopenjp2-7 libtiff6 libjpeg62-turbo \
  libwebp7 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0 libdeflate0 libjbig0 liblerc4
for package in *.deb; do dpkg -x "$package" root; done
cat > mask.py <<'P'
import sys
import numpy as np
import PIL
import tifffile
from PIL import Image

mask = np.zeros((6, 8), bool)
mask[1:3, 2:5] = True
tifffile.imwrite("tifffile.tif", mask)
Image.fromarray(mask).save("pillow.tif")
inverted = {}
for name in ("tifffile.tif", "pillow.tif"):
    page = tifffile.TiffFile(name).pages[0]
    by_tifffile, by_pillow = tifffile.imread(name), np.array(Image.open(name))
    same = {True: "the mask", False: "its complement"}
    print(f"{name}: photometric {int(page.photometric)}; tifffile {tifffile.__version__} reads {same[bool((by_tifffile == mask).all())]}, "
          f"Pillow {PIL.__version__} {same[bool((by_pillow == mask).all())]}")
    inverted[name] = bool((by_tifffile == mask).all() and (by_pillow == ~mask).all())
sys.exit(0 if inverted == {"tifffile.tif": True, "pillow.tif": False} else 1)
P
LD_LIBRARY_PATH=$folder/root/usr/lib/x86_64-linux-gnu PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 mask.py
