// SPDX-License-Identifier: BSD-3-Clause
import type { Report } from './schema';

function bytesOf(base64: string): ArrayBuffer {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

export const float32 = (base64: string): Float32Array<ArrayBuffer> => new Float32Array(bytesOf(base64));
export const uint8 = (base64: string): Uint8Array<ArrayBuffer> => new Uint8Array(bytesOf(base64));
export const uint16 = (base64: string): Uint16Array<ArrayBuffer> => new Uint16Array(bytesOf(base64));

/** The data of the page; throws if this front end does not support its schema. */
export function readData<Data extends { schema: number }>(schema: number): Data {
  const text = document.getElementById('report-data')?.textContent;
  if (!text) throw new Error('the page has no data');
  const data = JSON.parse(text) as Data;
  if (data.schema !== schema) throw new Error(`data have schema ${data.schema}, this page supports ${schema}`);
  return data;
}

export const readReport = (): Report => readData<Report>(2);

/** 53-bit hash (cyrb53), to distinguish data sets; not for security. */
export function hash53(parts: readonly string[]): string {
  let a = 0xdeadbeef;
  let b = 0x41c6ce57;
  for (const part of parts) {
    for (let i = 0; i < part.length; ++i) {
      const c = part.charCodeAt(i);
      a = Math.imul(a ^ c, 2654435761);
      b = Math.imul(b ^ c, 1597334677);
    }
  }
  a = Math.imul(a ^ (a >>> 16), 2246822507) ^ Math.imul(b ^ (b >>> 13), 3266489909);
  b = Math.imul(b ^ (b >>> 16), 2246822507) ^ Math.imul(a ^ (a >>> 13), 3266489909);
  return (4294967296 * (2097151 & b) + (a >>> 0)).toString(16);
}
