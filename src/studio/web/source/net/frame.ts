// SPDX-License-Identifier: GPL-3.0-or-later
// Binary messages: named arrays and a few words about them. src/studio/protocol.md describes the bytes.

export const protocolVersion = 1;

export type NumberArray = Float32Array | Uint32Array | Int32Array | Uint8Array;

export interface Frame {
  layer: string;
  data: Record<string, unknown>;
  arrays: Map<string, NumberArray>;
}

interface ArrayHeader {
  name: string;
  type: "f32" | "u32" | "i32" | "u8";
  offset: number;
  length: number;
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
  };
  const arrays = new Map<string, NumberArray>();
  for (const { name, type, offset, length } of header.arrays) arrays.set(name, makers[type](bytes, payload + offset, length));
  return { layer: header.layer, data: header.data, arrays };
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
