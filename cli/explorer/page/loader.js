// Unpacks the scripts of the page and the engine's WebAssembly, which join.mjs packs into one text and hands to
// start_page() at the end of this script.

/** The bytes of what join.mjs calls dense. @param {string} text @param {number} length */
function dense_bytes(text, length) {
  const taken = "\0\r$<\\`";
  const bytes = new Uint8Array(length);
  let [size, bits, count] = [0, 0, 0];
  const put = (/** @type {number} */ letter) => {
    bits = ((bits & 127) << 7) | letter;
    count += 7;
    if (count >= 8) bytes[size++] = bits >> (count -= 8);
  };
  for (let i = 0; i < text.length; ++i) {
    const letter = text.charCodeAt(i);
    if (letter >= 128) put(taken.charCodeAt((letter >> 7) - 1));
    put(letter & 127);
  }
  return bytes;
}

/** The first `length` bytes of a .lzma file.
 * @param {Uint8Array} packed @param {number} length */
function lzma_bytes(packed, length) {
  const view = new DataView(packed.buffer);
  const context_bits = packed[0] % 9;
  const place_mask = (1 << Math.floor(packed[0] / 9) % 5) - 1;
  const state_mask = (1 << Math.floor(packed[0] / 45)) - 1;
  const out = new Uint8Array(length);
  let size = 0;

  // The range decoder: each chance of a 0 bit is one of 2^11.
  let [range, code, at] = [0xffffffff, view.getUint32(14), 18];
  const chances = (/** @type {number} */ count) => new Uint16Array(count).fill(1024);
  const bit = (/** @type {Uint16Array} */ of, /** @type {number} */ i) => {
    const bound = (range >>> 11) * of[i];
    const one = code >>> 0 >= bound;
    if (one) {
      code -= bound;
      range -= bound;
      of[i] -= of[i] >> 5;
    } else {
      range = bound;
      of[i] += (2048 - of[i]) >> 5;
    }
    if (range < 1 << 24) {
      range = (range << 8) >>> 0;
      code = ((code << 8) | packed[at++]) >>> 0;
    }
    return one ? 1 : 0;
  };
  const plain_bits = (/** @type {number} */ count) => {
    let value = 0;
    while (count-- > 0) {
      range >>>= 1;
      const one = code >= range;
      if (one) code -= range;
      value = value * 2 + (one ? 1 : 0);
      if (range < 1 << 24) {
        range = (range << 8) >>> 0;
        code = ((code << 8) | packed[at++]) >>> 0;
      }
    }
    return value;
  };
  const tree = (/** @type {Uint16Array} */ of, /** @type {number} */ count, from = 0) => {
    let node = 1;
    for (let i = 0; i < count; ++i) node = node * 2 + bit(of, from + node);
    return node - (1 << count);
  };
  const reverse_tree = (/** @type {Uint16Array} */ of, /** @type {number} */ count, from = 0) => {
    let [node, value] = [1, 0];
    for (let i = 0; i < count; ++i) {
      const one = bit(of, from + node);
      node = node * 2 + one;
      value |= one << i;
    }
    return value;
  };
  const lengths = () => ({
    choice: chances(2),
    low: chances(128),
    middle: chances(128),
    high: chances(256),
  });
  const length_of = (/** @type {ReturnType<typeof lengths>} */ of, /** @type {number} */ place) => {
    if (!bit(of.choice, 0)) return 2 + tree(of.low, 3, place * 8);
    if (!bit(of.choice, 1)) return 10 + tree(of.middle, 3, place * 8);
    return 18 + tree(of.high, 8);
  };

  const literals = chances(0x300 << (context_bits + Math.log2(place_mask + 1)));
  const [matches, long_repeats] = [chances(192), chances(192)];
  const [repeats, seconds, thirds, fourths] = [chances(12), chances(12), chances(12), chances(12)];
  const [slots, aligned, near] = [chances(256), chances(16), chances(128)];
  const [new_length, repeated_length] = [lengths(), lengths()];
  let [state, a, b, c, d] = [0, 0, 0, 0, 0]; // the last four distances, less 1
  const copy = (/** @type {number} */ count) => {
    for (const end = size + count; size < end; ++size) out[size] = out[size - a - 1];
  };

  while (size < length) {
    const place = size & state_mask;
    if (!bit(matches, state * 16 + place)) {
      const before = size > 0 ? out[size - 1] : 0;
      const from = 0x300 * (((size & place_mask) << context_bits) + (before >> (8 - context_bits)));
      let symbol = 1;
      if (state >= 7) {
        let match = out[size - a - 1];
        while (symbol < 256) {
          const expected = (match >> 7) & 1;
          match <<= 1;
          const found = bit(literals, from + ((1 + expected) << 8) + symbol);
          symbol = symbol * 2 + found;
          if (found !== expected) break;
        }
      }
      while (symbol < 256) symbol = symbol * 2 + bit(literals, from + symbol);
      out[size++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
    } else if (bit(repeats, state)) {
      if (!bit(seconds, state)) {
        if (!bit(long_repeats, state * 16 + place)) {
          state = state < 7 ? 9 : 11;
          copy(1);
          continue;
        }
      } else if (!bit(thirds, state)) [a, b] = [b, a];
      else if (!bit(fourths, state)) [a, b, c] = [c, a, b];
      else [a, b, c, d] = [d, a, b, c];
      const count = length_of(repeated_length, place);
      state = state < 7 ? 8 : 11;
      copy(count);
    } else {
      [b, c, d] = [a, b, c];
      const count = length_of(new_length, place);
      state = state < 7 ? 7 : 10;
      const slot = tree(slots, 6, Math.min(count - 2, 3) * 64);
      a = slot;
      if (slot >= 4) {
        const more = (slot >> 1) - 1;
        const base = ((2 | (slot & 1)) << more) >>> 0;
        a =
          base +
          (slot < 14
            ? reverse_tree(near, more, base - slot)
            : plain_bits(more - 4) * 16 + reverse_tree(aligned, 4));
      }
      copy(count);
    }
  }
  return out;
}

/** @param {string} text @param {number} packed @param {number} length @param {number} engine Where its scripts end.
 * @param {number} page The same. */
function start_page(text, packed, length, engine, page) {
  const bytes = lzma_bytes(dense_bytes(text, packed), length);
  globalThis.stillpointWasm = bytes.slice(page);
  const decoder = new TextDecoder();
  globalThis.stillpointEngine = decoder.decode(bytes.subarray(0, engine));
  for (const code of [globalThis.stillpointEngine, decoder.decode(bytes.subarray(engine, page))]) {
    const script = document.createElement("script");
    script.textContent = code;
    document.body.append(script);
  }
}
