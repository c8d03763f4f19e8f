// Unpacks the arrays of the page (matching/report/packed_arrays.h).

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  if (typeof DecompressionStream === "undefined")
    throw new Error("this browser cannot decompress the data (DecompressionStream; browsers from 2023 on can)");
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// The unsigned integers whose bytes of the same rank stand together.
function integers(bytes, width) {
  const n = bytes.length / width;
  const values = width === 2 ? new Uint16Array(n) : new Uint32Array(n);
  for (let plane = 0; plane < width; ++plane)
    for (let i = 0; i < n; ++i) values[i] |= bytes[plane * n + i] << (8 * plane);
  return values;
}

// Points, as three coordinates each: those in the plane have z = 0.
function points(bytes, { components, entries, low, step }) {
  const differences = integers(bytes, 2);
  const coordinates = new Float32Array(3 * entries);
  for (let k = 0; k < components; ++k) {
    let steps = 0;
    for (let i = 0; i < entries; ++i) {
      steps = (steps + differences[k * entries + i]) & 0xffff;
      coordinates[3 * i + k] = low[k] + step * steps;
    }
  }
  return coordinates;
}

function indices(bytes) {
  const codes = integers(bytes, 4);
  let last = 0;
  for (let i = 0; i < codes.length; ++i) {
    const code = codes[i];
    last += code & 1 ? -(code + 1) / 2 : code / 2;
    codes[i] = last;
  }
  return codes;
}

const readers = {
  points,
  indices,
  numbers: (bytes) => new Float32Array(integers(bytes, 4).buffer),
  bytes: (bytes) => bytes,
};

/** The arrays that `descriptions` lists, by name. Points are Float32Arrays of x, y, z; numbers may be NaN. */
export async function unpack(descriptions, text) {
  const bytes = await inflated(bytesOfBase64(text));
  return Object.fromEntries(descriptions.map((a) => [a.name, readers[a.kind](bytes.subarray(a.offset, a.offset + a.bytes), a)]));
}
