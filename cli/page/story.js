// How the colour of a pixel comes about, term by term: from the JSON of `verisim explain`.
'use strict';

const rounded = v => v.map(x => +x.toPrecision(4)).join(' ');

// A linear colour as the screen shows it.
function chip(linear) {
  const box = document.createElement('span');
  box.className = 'chip';
  const encode = x => Math.round(255 * Math.min(1, Math.max(0, x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055)));
  box.style.background = `rgb(${linear.map(encode).join(',')})`;
  return box;
}

// What the terms of a ray's colour are; those that come with other rays can be unfolded.
function sumOf(ray) {
  const list = document.createElement('ul');
  list.className = 'sum';
  for (const term of ray.sum || []) {
    const item = document.createElement('li'), layer = ray.layers && ray.layers[term.layer];
    const words = document.createElement('span');
    words.append(chip(term.adds), ` ${rounded(term.adds)}  `, term.what, layer ? ` on ${layer.object}` : '');
    if (!term.rays) {
      item.append(words);
    } else {
      const more = document.createElement('details'), head = document.createElement('summary');
      more.open = true;
      head.append(words);
      more.append(head);
      for (const child of ray.rays.slice(term.rays[0], term.rays[1])) {
        if (child.kind === 'cut off') { more.append(`not traced: ${child.reason}`); continue; }
        const share = child.color.map((c, i) => c ? term.adds[i] / c : 0), note = document.createElement('p');
        note.append(`${rounded(share)} of the ${child.kind} ray's colour `, chip(child.color), ` ${rounded(child.color)}, which is the sum of`);
        if (term.rays[1] - term.rays[0] === 1) more.append(note);
        more.append(sumOf(child));
      }
      item.append(more);
    }
    list.append(item);
  }
  if (!list.children.length) list.append('nothing: it is black');
  return list;
}

// The result of a pixel: linear, as stored, and POV-Ray's where it was asked.
function resultOf(story) {
  const line = document.createElement('p');
  line.append(chip(story.linear), ` linear ${rounded(story.linear)}; in a file of 8 bits ${story.stored.join(' ')}`, story.oracle ? `; ${story.oracle}` : '');
  return line;
}
