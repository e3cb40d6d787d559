// Text as a part of an address: deflated, in base64url.

export async function pack(text) {
  const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(text), Infinity);
  let letters = '';
  for (let i = 0; i < bytes.length; i += 4096) {
    letters += String.fromCharCode(...bytes.subarray(i, i + 4096));
  }

  return btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

// throws where it is damaged, is no text, or exceeds the limit
export async function unpack(packed, most) {
  if (!/^[\w-]+$/.test(packed)) {
    throw new Error('not base64url');
  }

  const letters = atob(packed.replace(/-/g, '+').replace(/_/g, '/'));
  const bytes = await through(new DecompressionStream('deflate-raw'), Uint8Array.from(letters, letter => letter.charCodeAt(0)), most);
  return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
}

async function through(stream, bytes, most) {
  const writer = stream.writable.getWriter();
  // the reader reports errors in them
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  const parts = [];
  let length = 0;
  for await (const part of read(stream.readable.getReader())) {
    length += part.length;
    if (length > most) {
      throw new Error('too long');
    }

    parts.push(part);
  }

  const all = new Uint8Array(length);
  parts.reduce((at, part) => (all.set(part, at), at + part.length), 0);
  return all;
}

// streams are no iterators in every browser
async function* read(reader) {
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    yield next.value;
  }
}
