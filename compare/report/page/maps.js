// Maps of what differs: computed from the two pictures, or made beforehand (FLIP, SSIM, p-values).
const SCALE = [[0, 0, 4], [51, 10, 95], [120, 28, 109], [187, 55, 84], [237, 105, 37], [251, 181, 26], [252, 255, 164]];
const SIGNED = [[140, 200, 255], [40, 110, 220], [10, 40, 110], [12, 12, 16], [120, 20, 20], [225, 70, 40], [255, 190, 140]];  // less, equal, more
const along = (scale, t) => {
  const at = clamp(t, 0, 1) * (scale.length - 1), i = Math.min(Math.floor(at), scale.length - 2);
  return scale[i].map((v, c) => v + (at - i) * (scale[i + 1][c] - v));
};
const toLinear = v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
const toScreen = v => v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;
const codeValue = v => Math.sign(v) * 255 * (Math.abs(v) <= 1 ? toScreen(Math.abs(v)) : 1 + 1.055 / 2.4 * Math.log(Math.abs(v)));  // docs/comparison.md
const LINEAR = Float32Array.from({ length: 256 }, (_, v) => toLinear(v / 255));

// ---- values finer than 8 bits ----
function halfOf(bits) {
  const sign = bits & 0x8000 ? -1 : 1, exponent = bits >> 10 & 31, mantissa = bits & 1023;
  if (exponent === 31) return mantissa ? NaN : sign * Infinity;
  return sign * (exponent ? 2 ** (exponent - 15) * (1 + mantissa / 1024) : 2 ** -24 * mantissa);
}
let halves = null;
async function fineValues(i, key) {  // { codes, linear, text(at) }: three values a pixel
  const planes = await decode(i, key);
  if (!planes) return null;
  const count = planes.pixels.length / 8, codes = new Float32Array(3 * count), linear = new Float32Array(3 * count), floats = scenes[i].fine === 'half';
  if (floats && !halves) halves = Float32Array.from({ length: 65536 }, (_, bits) => halfOf(bits));
  for (let at = 0, to = 0; at < 4 * count; at += 4) for (let c = 0; c < 3; c++, to++) {
    const bits = planes.pixels[at + c] << 8 | planes.pixels[4 * count + at + c];
    linear[to] = floats ? halves[bits] : toLinear(bits / 65535);
    codes[to] = floats ? codeValue(halves[bits]) : bits / 257;
  }
  return { codes, linear, floats, text: at => floats ? (+linear[at].toPrecision(4)).toString() : codes[at].toFixed(2) };
}
// Floats as a screen shows them at an exposure (stops) and an offset.
function expose(pic) {
  const g = pic.canvas.getContext('2d'), out = g.createImageData(pic.width, pic.height), gain = 2 ** +$('exposure').value, offset = +$('offset').value;
  for (let i = 0, from = 0; i < out.data.length; i += 4) {
    for (let c = 0; c < 3; c++) out.data[i + c] = 255 * toScreen(clamp(pic.fine.linear[from++] * gain + offset, 0, 1));
    out.data[i + 3] = 255;
  }
  g.putImageData(out, 0, 0);
  pic.pixels = out.data;
}
const codeAt = (pic, at, c) => pic.fine ? pic.fine.codes[3 * at + c] : pic.pixels[4 * at + c];
const linearAt = (pic, at, c) => pic.fine ? pic.fine.linear[3 * at + c] : LINEAR[pic.pixels[4 * at + c]];

// ---- the kinds of maps: value(at) of a pixel; top: the end of the scale; unit ----
const overPixels = value => (o, n, count) => Float32Array.from({ length: count }, (_, at) => value(o, n, at));
const largest = overPixels((o, n, at) => Math.max(...[0, 1, 2].map(c => Math.abs(codeAt(n, at, c) - codeAt(o, at, c)))));
const meanSigned = overPixels((o, n, at) => (codeAt(n, at, 0) - codeAt(o, at, 0) + codeAt(n, at, 1) - codeAt(o, at, 1) + codeAt(n, at, 2) - codeAt(o, at, 2)) / 3);
const relative = overPixels((o, n, at) => {
  const a = linearAt(o, at, 0) + linearAt(o, at, 1) + linearAt(o, at, 2), b = linearAt(n, at, 0) + linearAt(n, at, 1) + linearAt(n, at, 2);
  return 100 * (b - a) / Math.max(Math.abs(a), 0.01);
});
const MAPS = {
  difference: { label: 'Difference', unit: 'code values', values: largest, scaled: true, digits: 2 },
  signed: { label: 'Signed difference', unit: 'code values, mean of the channels', values: meanSigned, scaled: true, signed: true, digits: 2 },
  relative: { label: 'Relative difference', unit: '% of the linear value', values: relative, signed: true, top: 100, digits: 1 },
  flip: { label: 'FLIP', unit: 'FLIP', stored: 'flip', top: 1, digits: 2 },
  ssim: { label: '1 − SSIM', unit: '1 − SSIM', stored: 'ssim', top: 1, digits: 2 },
  p: { label: 'p-values', unit: '−log₁₀ p', stored: 'p', top: 10, digits: 1 },
};
const different = values => {
  const wrong = values.filter(v => v !== 0 && !isNaN(v)).map(Math.abs).sort();
  return wrong.length ? wrong[Math.floor(0.95 * (wrong.length - 1))] : 0;
};
let mapsAsked = 0;
async function makeMap() {
  const asked = ++mapsAsked, i = eye.index, s = scenes[i], kind = $('map').value, m = MAPS[kind];
  let values = null;
  if (m.stored) {
    const picture = await decode(i, m.stored).catch(() => null);
    if (picture) values = Float32Array.from({ length: picture.width * picture.height }, (_, at) => picture.pixels[4 * at] / 255 * m.top);
  } else if (eye.o && eye.n && eye.o.width === eye.n.width && eye.o.height === eye.n.height) {
    values = m.values(eye.o, eye.n, eye.o.width * eye.o.height);
  }
  if (eye.index !== i || asked !== mapsAsked) return;
  eye.map = null;
  if (values) {
    const wanted = $('scale').value, log = m.scaled && wanted === 'log';
    const top = !m.scaled ? m.top : log ? 255 : wanted !== 'auto' ? +wanted : [0.25, 1, 4, 16, 64, 255].find(t => t >= different(values)) || 255;
    const part = log ? v => Math.log2(1 + v) / 8 : v => v / top;
    const c = node('canvas', { width: eye.width, height: eye.height }), g = c.getContext('2d'), out = g.createImageData(c.width, c.height);
    for (let at = 0; at < values.length; at++) {
      const v = isNaN(values[at]) ? top : values[at];
      out.data.set(m.signed ? along(SIGNED, 0.5 + 0.5 * Math.sign(v) * part(Math.abs(v))) : along(SCALE, part(v)), 4 * at);
      out.data[4 * at + 3] = 255;
    }
    g.putImageData(out, 0, 0);
    const hdr = kind === 'flip' && s.exposures ? `, ${s.exposures[2]} exposures from ${fixed(s.exposures[0], 1)} to ${fixed(s.exposures[1], 1)} stops` : '';
    eye.map = { canvas: c, pixels: out.data, width: c.width, height: c.height, values, name: m.label, top, log, signed: m.signed, unit: m.unit + hdr, text: at => fixed(values[at], values[at] % 1 ? m.digits : 0) };
    if (kind === 'flip') flipHistogram(values);
  }
  makeLegend(); draw();
}
function makeLegend() {
  const map = eye.map;
  $('legend').hidden = !map || !['all', 'heat'].includes(eye.mode);
  if (!map) return;
  const g = $('legend-bar').getContext('2d'), scale = map.signed ? SIGNED : SCALE;
  for (let x = 0; x < 256; x++) { g.fillStyle = `rgb(${along(scale, x / 255).map(Math.round)})`; g.fillRect(x, 0, 1, 1); }
  const round = v => String(+v.toPrecision(3)), top = map.top;
  const ticks = map.log && !map.signed ? [0, 1, 3, 15, 63, 255].map(String) : (map.signed ? [-1, -0.5, 0, 0.5, 1] : [0, 0.25, 0.5, 0.75, 1]).map(t => (t > 0 && map.signed ? '+' : '') + round(map.log ? Math.sign(t) * (2 ** (8 * Math.abs(t)) - 1) : t * top));
  $('legend-ticks').replaceChildren(...ticks.map(t => node('span', {}, t)));
  $('legend-unit').textContent = `${map.name}: ${map.unit}`;
}
