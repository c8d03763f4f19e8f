#!/bin/sh
# Teem 1.12.0 (Debian 12), `unu dist`: distances are meant to end at the faces of the body's voxels, for which half a voxel is taken off the
# distance to the nearest voxel of the body. With unequal spacings it is half of their mean that is taken off, in every direction, and what
# falls below 0 becomes 0. At 0.5 x 0.5 x 5 mm the signed distance (-sgn) of a body 4 voxels wide is 0 all through the body and for two voxels
# beside it, and 4 mm for the voxel above, whose middle is 2.5 mm away. The help says that non-isotropic samples are handled correctly.
set -eu
version=1.12.0~20160122-5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "teem-apps=$version" "libteem2=$version" libpng16-16 libbz2-1.0
for package in *.deb; do dpkg -x "$package" root; done
lib=$(find "$folder/root" -name 'libteem.so.2' -exec dirname {} \; | head -n 1)
unu() { LD_LIBRARY_PATH=$lib:$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/lib/x86_64-linux-gnu root/usr/bin/teem-unu "$@"; }
# Signed distances of a body of 4 x 4 x 3 voxels amid 12 x 12 x 9: along x through its middle, then along z.
distances() {
  {
    printf 'NRRD0005\ntype: uint8\ndimension: 3\nsizes: 12 12 9\nspacings: %s\nencoding: ascii\n\n' "$1"
    awk 'BEGIN { for (k = 0; k < 9; ++k) for (j = 0; j < 12; ++j) for (i = 0; i < 12; ++i) print (i > 3 && i < 8 && j > 3 && j < 8 && k > 2 && k < 6) }'
  } | unu dist -th 0.5 -sgn -o out.nrrd
  unu slice -i out.nrrd -a 2 -p 4 | unu slice -a 1 -p 5 | unu save -f text | tr '\n' ' '
  unu slice -i out.nrrd -a 1 -p 5 | unu slice -a 0 -p 5 | unu save -f text | tr '\n' ' '
}
equal=$(distances "1 1 1")
unequal=$(distances "0.5 0.5 5")
echo "1 x 1 x 1 mm, along x and z:     $equal"
echo "0.5 x 0.5 x 5 mm, along x and z: $unequal"
[ "$equal" = "3.5 2.5 1.5 0.5 -0.5 -1.5 -1.5 -0.5 0.5 1.5 2.5 3.5 2.5 1.5 0.5 -0.5 -1.5 -0.5 0.5 1.5 2.5 " ]
[ "$unequal" = "1 0.5 0 0 0 0 0 0 0 0 0.5 1 14 9 4 0 0 0 4 9 14 " ]
