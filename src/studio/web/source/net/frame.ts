// SPDX-License-Identifier: GPL-3.0-or-later
// Binary messages: named arrays and a few words about them. src/studio/protocol.md describes the bytes.

export const protocolVersion = 2;

export type NumberArray = Float32Array | Uint32Array | Int32Array | Uint8Array;

interface Made {
  name: string;
  type: "f32" | "u32" | "i32" | "u8";
  length: number;
}
interface ArrayHeader extends Made {
  offset: number;
}

export interface Frame {
  layer: string;
  data: Record<string, unknown>;
  arrays: Map<string, NumberArray>;
  /** Of a message that says what changed of the layer: the arrays that it makes. */
  patch?: Made[];
}

const makers = {
  f32: (b: ArrayBuffer, o: number, n: number): NumberArray => new Float32Array(b, o, n),
  u32: (b: ArrayBuffer, o: number, n: number): NumberArray => new Uint32Array(b, o, n),
  i32: (b: ArrayBuffer, o: number, n: number): NumberArray => new Int32Array(b, o, n),
  u8: (b: ArrayBuffer, o: number, n: number): NumberArray => new Uint8Array(b, o, n),
};

/** Reads a binary message; throws an Error where it is not what the protocol describes. The arrays share its memory. */
export function decodeFrame(bytes: ArrayBuffer): Frame {
  const view = new DataView(bytes);
  if (bytes.byteLength < 8 || view.getUint8(0) !== 82 || view.getUint8(1) !== 81 || view.getUint8(2) !== 83)
    throw new Error("this is no message of the studio");
  if (view.getUint8(3) !== protocolVersion) throw new Error("the program speaks another version of the protocol");
  const headerLength = view.getUint32(4, true);
  const payload = 8 + headerLength;
  if (headerLength % 8 !== 0 || payload > bytes.byteLength) throw new Error("the message is cut off");
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 8, headerLength))) as {
    layer: string;
    arrays: ArrayHeader[];
    data: Record<string, unknown>;
    patch?: Made[];
  };
  const arrays = new Map<string, NumberArray>();
  for (const { name, type, offset, length } of header.arrays) arrays.set(name, makers[type](bytes, payload + offset, length));
  return { layer: header.layer, data: header.data, arrays, ...(header.patch && { patch: header.patch }) };
}

/** The layer that a message makes of the layer that was there; the message itself if it is whole. */
export function patched(before: Frame | undefined, message: Frame): Frame {
  if (!message.patch) return message;
  if (!before) throw new Error(`what changed of ${message.layer} came before the layer`);
  const arrays = new Map<string, NumberArray>();
  for (const made of message.patch) arrays.set(made.name, patchedArray(before.arrays.get(made.name), message, made));
  return { layer: message.layer, data: message.data, arrays };
}

/** The bits of an array's numbers. */
function bits(array: NumberArray): Uint8Array | Uint32Array {
  return array instanceof Uint8Array ? array : new Uint32Array(array.buffer, array.byteOffset, array.length);
}

function patchedArray(before: NumberArray | undefined, message: Frame, made: Made): NumberArray {
  const steps = message.arrays.get(`${made.name}.steps`), fresh = message.arrays.get(made.name);
  if (!steps || !fresh) throw new Error(`${message.layer} does not say what changed of '${made.name}'`);
  const old = renamed(before ? bits(before) : new Uint32Array(), message, made.name), repeats = made.type === "i32";
  const out = makers[made.type](new ArrayBuffer(made.length * (made.type === "u8" ? 1 : 4)), 0, made.length);
  const to = bits(out);
  let read = 0, from = 0, at = 0, taken = 0;
  const number = (): number => {
    let value = 0, scale = 1;
    for (;;) {
      const byte = steps[read++];
      if (byte === undefined) throw new Error(`what changed of ${message.layer} is cut off`);
      value += (byte & 127) * scale;
      if (byte < 128) return value;
      scale *= 128;
    }
  };
  while (at < made.length) {
    const length = number();
    if (length > 0) {
      const shift = number();
      from += shift % 2 ? -(shift + 1) / 2 : shift / 2;
      if (from < 0 || from + length > old.length) throw new Error(`${message.layer} is another one than the program knows`);
      to.set(old.subarray(from, from + length), at);
      from += length;
      at += length;
    }
    const added = number();
    if (repeats && added > 0) to.fill(fresh[taken++]!, at, at + added);
    else if (added > 0) to.set(fresh.subarray(taken, (taken += added)), at);
    from += added;
    at += added;
  }
  return out;
}

/** The old numbers, with those that are called otherwise now under their new name. */
function renamed(old: Uint8Array | Uint32Array, message: Frame, name: string): Uint8Array | Uint32Array {
  const from = message.arrays.get(`${name}.from`), to = message.arrays.get(`${name}.to`);
  if (!from || !to) return old;
  const names = new Map(Array.from(from, (value, i) => [value, to[i]!]));
  const out = old.slice();
  let last = out[0], now = names.get(last!) ?? last!; // the same number mostly stands many times in a row
  for (let i = 0; i < out.length; ++i) {
    const value = out[i]!;
    if (value !== last) {
      last = value;
      now = names.get(value) ?? value;
    }
    out[i] = now;
  }
  return out;
}

/** An array of a frame that must be there. */
export function floats(frame: Frame, name: string): Float32Array {
  const array = frame.arrays.get(name);
  if (!(array instanceof Float32Array)) throw new Error(`${frame.layer} has no numbers '${name}'`);
  return array;
}
export function indices(frame: Frame, name: string): Uint32Array {
  const array = frame.arrays.get(name);
  if (!(array instanceof Uint32Array)) throw new Error(`${frame.layer} has no indices '${name}'`);
  return array;
}
export function integers(frame: Frame, name: string): Int32Array {
  const array = frame.arrays.get(name);
  return array instanceof Int32Array ? array : new Int32Array();
}
export function bytesOf(frame: Frame, name: string): Uint8Array {
  const array = frame.arrays.get(name);
  return array instanceof Uint8Array ? array : new Uint8Array();
}
