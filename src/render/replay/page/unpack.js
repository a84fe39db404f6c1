// Format 2, as src/render/replay/README.md of tumble describes it.

async function inflate(id) {
  const text = atob(document.getElementById(id).textContent.trim());
  if (text.length === 0) return null;
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < packed.length; i++) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class ByteReader {
  constructor(bytes) { this.bytes = bytes; this.at = 0; }

  varint() {
    let byte = this.bytes[this.at++];
    if (byte < 128) return byte;
    let value = byte & 127, weight = 128;
    do {
      byte = this.bytes[this.at++];
      value += (byte & 127) * weight;
      weight *= 128;
    } while (byte >= 128);
    return value;
  }

  signed() {
    const bits = this.varint();
    return bits % 2 === 0 ? bits / 2 : -(bits + 1) / 2;
  }

  text(length) {
    this.at += length;
    return new TextDecoder().decode(this.bytes.subarray(this.at - length, this.at));
  }
}

// Integers that were packed as second differences.
function unpackPredicted(reader, into, from, count) {
  let last = 0, before = 0;
  for (let i = 0; i < count; i++) {
    const value = reader.signed() + 2 * last - before;
    before = last;
    last = value;
    into[from + i] = value;
  }
}

function unpackStates(bytes) {
  const reader = new ByteReader(bytes);
  const header = JSON.parse(reader.text(reader.varint()));
  if (header.format !== 2) throw new Error(`this page reads format 2, and the states have format ${header.format}`);
  let poses = 0;
  for (const body of header.bodies) {
    body.first = poses;  // index of its first pose
    poses += body.count;
  }
  const states = { ...header, x: new Int32Array(poses), y: new Int32Array(poses), angle: new Int32Array(poses) };
  for (const sequence of [states.x, states.y, states.angle])
    for (const body of header.bodies) unpackPredicted(reader, sequence, body.first, body.count);
  return states;
}

// Integers of all tracks that were packed as first differences.
function unpackDifferences(reader, { tracks, first, count }, points) {
  const into = new Int32Array(points);
  for (let i = 0; i < tracks; i++)
    for (let k = 0, value = 0; k < count[i]; k++) into[first[i] + k] = value += reader.signed();
  return into;
}

// Contact points by track: from[i] to from[i] + count[i] - 1 are its steps, first[i] the index of its first point.
function unpackContacts(bytes) {
  const reader = new ByteReader(bytes);
  const tracks = reader.varint();
  const contacts = { tracks, a: new Int32Array(tracks), b: new Int32Array(tracks), from: new Int32Array(tracks),
                     count: new Int32Array(tracks), first: new Int32Array(tracks), points: [] };
  let step = 0, points = 0;
  for (let i = 0; i < tracks; i++) {
    contacts.from[i] = step += reader.varint();
    const count = contacts.count[i] = reader.varint();
    contacts.a[i] = reader.varint();
    contacts.b[i] = reader.varint();
    contacts.first[i] = points;
    points += count;
  }
  for (let kind = 0; kind < 4; kind++) contacts.points.push(unpackDifferences(reader, contacts, points));
  contacts.inPart = tracksByPart(contacts);
  return contacts;
}

// The tracks of a step are found among those of its part of the run: inPart[i] are the tracks with a point in the steps
// from i * STEPS_PER_PART on, in their order.
const STEPS_PER_PART = 64;

function tracksByPart({ tracks, from, count }) {
  const part = (step) => Math.floor(step / STEPS_PER_PART), sizes = [];
  const eachPart = (visit) => {
    for (let i = 0; i < tracks; i++)
      for (let k = part(from[i]); k <= part(from[i] + count[i] - 1); k++) visit(k, i);
  };
  eachPart((k) => { sizes[k] = (sizes[k] ?? 0) + 1; });
  const parts = Array.from(sizes, (size) => new Int32Array(size ?? 0)), filled = sizes.map(() => 0);
  eachPart((k, i) => { parts[k][filled[k]++] = i; });
  return parts;
}
