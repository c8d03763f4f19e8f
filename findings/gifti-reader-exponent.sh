#!/bin/sh
# gifti-reader-js 0.4.6 (npm, the reader of Papaya): in a GIFTI data array with Encoding="ASCII", a number with an exponent is taken for two
# numbers, and of '.5' the point is lost. One coordinate that is nearly 0, as 6.1e-17, becomes 6.1 and -17 and moves all coordinates after it
# by one place: the points of a circle of radius 1, written as JavaScript writes numbers, come back up to 18 from its centre, 15 numbers for an
# array of 4 x 3, with no error. The README says that ASCII is supported and names no such limit, and nibabel 5.0.0 reads the same file well;
# the reader takes numbers by the pattern /[+-]?\d+(\.\d+)?/g (src/dataArray.js, readFloat32ASCII). With six decimals all is read well.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --ignore-scripts gifti-reader-js@0.4.6 sax@1.4.1 fflate@0.8.2 string_decoder@1.3.0 buffer@6.0.3 >/dev/null
cat > circle.js <<'C'
const gifti = require('gifti-reader-js');
const read = (text) => gifti.parse(`<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE GIFTI SYSTEM "http://www.nitrc.org/frs/download.php/115/gifti.dtd">
<GIFTI Version="1.0" NumberOfDataArrays="1"><MetaData/><LabelTable/>
<DataArray Intent="NIFTI_INTENT_POINTSET" DataType="NIFTI_TYPE_FLOAT32" ArrayIndexingOrder="RowMajorOrder" Dimensionality="2" Dim0="4" Dim1="3"
 Encoding="ASCII" Endian="LittleEndian" ExternalFileName="" ExternalFileOffset=""><MetaData/>
<CoordinateSystemTransformMatrix><DataSpace>NIFTI_XFORM_UNKNOWN</DataSpace><TransformedSpace>NIFTI_XFORM_UNKNOWN</TransformedSpace>
<MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData></CoordinateSystemTransformMatrix><Data>${text}</Data></DataArray></GIFTI>`);
const points = [0, 1, 2, 3].map((k) => [Math.cos(k * Math.PI / 2), Math.sin(k * Math.PI / 2), 0]);
const seen = [(v) => v.toFixed(6), (v) => String(v)].map((write) => {
  const text = points.map((p) => p.map(write).join(' ')).join('\n');
  const surface = read(text), data = surface.getPointsDataArray().getData();
  const radii = [...Array(surface.getNumPoints()).keys()].map((i) => Math.hypot(...data.slice(3 * i, 3 * i + 3)).toFixed(2)).join(' ');
  console.log(`${text}\n-> ${data.length} numbers for ${surface.getNumPoints()} points, distances from the centre ${radii}`);
  return radii;
});
const half = read('.5 0 0 0 0 0 0 0 0 0 0 0').getPointsDataArray().getData()[0];
console.log(`.5 is read as ${half}`);
process.exit(seen[0] === '1.00 1.00 1.00 1.00' && seen[1] === '1.00 18.10 1.58 16.11' && half === 5 ? 0 : 1);
C
node circle.js
