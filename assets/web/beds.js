// The run's beds, unpacked: src/web/packed_fields.h tells how they are packed.
const run = JSON.parse(document.getElementById("data").textContent);
const [columns, rows] = run.cells;
const cellCount = columns * rows;
document.getElementById("data").remove();

function bytesOf(letters) {
  const text = atob(letters);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(letters) {
  const stream = new Blob([bytesOf(letters)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function expected(numbers, at, x, y, predictor) {
  if (predictor === 0) return 0;
  const west = x > 0 ? numbers[at - 1] : 0;
  const south = y > 0 ? numbers[at - columns] : 0;
  if (x === 0 || y === 0) return west + south;
  return predictor === 1 ? west + south - numbers[at - columns - 1] : (west + south) >> 1;
}

/** The 16-bit numbers of all fields of a series. */
async function unpacked(series) {
  const all = [];
  for (const [overPrevious, predictor, letters] of series.fields) {
    const bytes = await inflated(letters);
    const numbers = new Uint16Array(cellCount);
    for (let y = 0, at = 0; y < rows; ++y) {
      for (let x = 0; x < columns; ++x, ++at) {
        const folded = (bytes[at] << 8) | bytes[cellCount + at];
        numbers[at] = expected(numbers, at, x, y, predictor) + ((folded >> 1) ^ -(folded & 1));
      }
    }
    if (overPrevious) {
      const previous = all[all.length - 1];
      for (let i = 0; i < cellCount; ++i) numbers[i] += previous[i];
    }
    all.push(numbers);
  }
  series.fields = null;
  return all;
}

const beds = { heights: [], depths: null, nodata: null };

async function unpackBeds() {
  beds.heights = await unpacked(run.heights);
  if (run.depths) beds.depths = await unpacked(run.depths);
  if (run.nodata) beds.nodata = await inflated(run.nodata);
}

const hasData = (cell) => !beds.nodata || beds.nodata[cell] === 0;
const heightOf = (bed, cell) => run.heights.low + run.heights.step * beds.heights[bed][cell];
const depthOf = (bed, cell) => (beds.depths ? run.depths.low + run.depths.step * beds.depths[bed][cell] : 0);

/** z of the ground and of what is seen over it, in the block's lengths. */
function surfacesOf(bed) {
  const ground = new Float32Array(cellCount);
  const surface = new Float32Array(cellCount);
  const reference = run.beds[bed].reference;
  for (let cell = 0; cell < cellCount; ++cell) {
    ground[cell] = (heightOf(bed, cell) - reference) * run.upward;
    surface[cell] = ground[cell] + depthOf(bed, cell) * run.upward;
  }
  return { ground, surface };
}

/** Its colours from above, as fumon drew them. */
function pictureOf(bed) {
  const file = new Blob([bytesOf(run.beds[bed].picture)], { type: "image/webp" });
  return createImageBitmap(file, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
}
