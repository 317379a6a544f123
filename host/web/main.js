// The page: the text of a scene and settings, three displays, and the link that holds both.
//
// A worker checks what is typed; only what it admits is drawn, by one worker for each display. A drawing that is no longer wanted
// ends with its worker. The frames of a film stay in memory as a display has them, indices and a colour table, and are shown over and over.

const $ = (id) => document.getElementById(id);
const SETTINGS = ['model', 'format', 'depth', 'table', 'dither', 'size', 'motion', 'instant', 'frames', 'rate'];
// After so many milliseconds without a key the text is looked at.
const PAUSE = 150;
// What a page shows unless its link says otherwise.
const FIRST = {
  model: 'auto', format: 'q16', depth: 'auto', table: 'sampled', dither: 'auto', size: '1', motion: 'still', instant: '0', frames: '24', rate: '20',
};

const module = await WebAssembly.compileStreaming(fetch('rta.wasm')).catch((error) => {
  $('message').textContent = `the module rta.wasm cannot be loaded; host/web/build makes it: ${error.message}`;
  throw error;
});

// The picture files that the page was given, by name, as one worker has decoded them for all.
const pictures = new Map();

function worker(hear) {
  const made = new Worker('worker.js');
  made.onmessage = ({ data }) => hear(data);
  made.postMessage({ module });
  pictures.forEach((contents, name) => made.postMessage({ kind: 'picture', name, contents }));
  return made;
}

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// Colours.

const hex = (color) => `#${color.map((level) => level.toString(16).padStart(2, '0')).join('')}`;

function swatch(color) {
  const made = element('i', { className: 'color' });
  made.style.background = hex(color);
  return made;
}

// A display: its picture, its colour table and the worker that draws it. A picture is a film of one frame.

class Display {
  constructor(about) {
    this.about = about;
    this.picture = element('canvas', { className: 'picture', width: about.width, height: about.height });
    this.picture.style.aspectRatio = String(about.aspect);
    this.table = element('canvas', { className: 'table', width: 32, height: Math.ceil(about.colors / 32) });
    this.state = element('span');
    const guns = `${about.colors} colours of ${(about.guns ** 3).toLocaleString('en')}`;
    const caption = element('figcaption', {}, element('b', { textContent: about.name }), ` ${about.width} x ${about.height}, ${guns}; `, this.state);
    this.figure = element('figure', { id: about.name }, this.picture, this.table, caption);
    this.picture.onmousemove = (event) => this.point(event);
    this.job = 0;
    this.worker = null;
    this.busy = false;
    this.asked = false;
    this.pixel = null;
    this.film = [];
    this.frames = 1;
    this.shown = 0;
  }

  tell(state, text) {
    this.figure.dataset.state = state;
    this.state.textContent = text;
  }

  // Draws what is requested, instead of what is being drawn.
  draw(request) {
    if (this.busy) {
      this.worker.terminate();
      this.worker = null;
    }
    this.worker ??= worker((data) => this.hear(data));
    this.job += 1;
    this.asked = false;
    this.busy = true;
    this.begin = performance.now();
    this.tell('drawing', 'begins');
    this.worker.postMessage({ job: this.job, kind: 'start', request });
  }

  hear({ job, started, rows, done, explained, failed }) {
    if (job !== this.job) {
      return;
    }
    if (started !== undefined) {
      // The picture before stays until rows come in its place, unless it has another size.
      const { width, height, frames } = started;
      if (this.picture.width !== width || this.picture.height !== height) {
        Object.assign(this.picture, { width, height });
      }
      this.frames = frames;
      this.film = [];
    } else if (rows !== undefined) {
      this.draws(rows);
    } else if (done) {
      this.busy = false;
      const seconds = ((performance.now() - this.begin) / 1000).toFixed(2);
      const what = this.frames > 1 ? `${this.frames} frames of ` : '';
      this.tell('done', `${what}${this.picture.width} x ${this.picture.height} pixels in ${seconds} s`);
    } else if (explained !== undefined) {
      explain(this.about.name, explained);
      this.answered();
    } else if (failed?.kind === 'explain' && !failed.ended) {
      this.answered();
    } else if (failed !== undefined) {
      if (failed.ended) {
        this.worker.terminate();
        this.worker = null;
      }
      this.busy = false;
      this.tell('failed', failed.message);
    }
  }

  // Rows of a frame: the first frame is shown as it is drawn, the others once they are complete.
  draws({ frame, first, indices, colors }) {
    const { width, height } = this.picture;
    if (first === 0) {
      this.film.push({ indices: new Uint8Array(width * height), colors });
    }
    const coming = this.film.at(-1);
    coming.indices.set(indices, first * width);
    coming.colors = colors;
    const done = first + indices.length / width;
    if (frame === 0) {
      this.show(0, first, indices, colors);
    } else if (done === height) {
      this.show(frame, 0, coming.indices, colors);
    }
    const which = this.frames > 1 ? `frame ${frame + 1} of ${this.frames}, ` : '';
    this.tell('drawing', `${which}row ${done} of ${height}, ${colors.length / 3} colours`);
  }

  // Shows rows of a frame by its colour table, as the display's converter does, and the table.
  show(frame, first, indices, colors) {
    this.shown = frame;
    this.figure.dataset.frame = frame;
    const table = new ImageData(this.table.width, this.table.height);
    for (let entry = 0; entry < colors.length / 3; entry += 1) {
      table.data.set([...colors.subarray(3 * entry, 3 * entry + 3), 255], 4 * entry);
    }
    this.table.getContext('2d').putImageData(table, 0, 0);
    const { width } = this.picture;
    const image = new ImageData(width, indices.length / width);
    const [entries, pixels] = [table, image].map(({ data }) => new Uint32Array(data.buffer));
    for (let pixel = 0; pixel < indices.length; pixel += 1) {
      pixels[pixel] = entries[indices[pixel]];
    }
    this.picture.getContext('2d').putImageData(image, 0, first);
  }

  // Shows the frame of a film whose turn it is, the frames shown so far being counted by one clock for all displays.
  turn(count) {
    const frame = count % this.frames;
    if (!this.busy && this.film.length === this.frames && frame !== this.shown) {
      const { indices, colors } = this.film[frame];
      this.show(frame, 0, indices, colors);
    }
  }

  // Asks for the pixel under the mouse; while an answer is awaited, only the last pixel is kept.
  point({ offsetX, offsetY }) {
    if (this.frames > 1) {
      const said = 'A film plays. In the picture of an instant, the pixel under the mouse is explained here.';
      $('explanation').replaceChildren(element('h2', { textContent: said }));
      return;
    }
    const { width, height, clientWidth, clientHeight } = this.picture;
    const along = (at, length, pixels) => Math.min(Math.max(Math.floor((at * pixels) / length), 0), pixels - 1);
    this.pixel = { x: along(offsetX, clientWidth, width), y: along(offsetY, clientHeight, height) };
    if (!this.asked && this.worker !== null) {
      this.ask();
    }
  }

  ask() {
    this.asked = true;
    this.worker.postMessage({ job: this.job, kind: 'explain', ...this.pixel });
    this.pixel = null;
  }

  answered() {
    this.asked = false;
    if (this.pixel !== null) {
      this.ask();
    }
  }
}

// The explanation of a pixel.

const decimals = (light) => light.map((register) => register.toFixed(4)).join(' ');

function explain(name, { x, y, light, samples, index, color, rays, tree, untold }) {
  const title = element('h2', { textContent: `${name}, pixel ${x},${y}` });
  const seen = element('div', {}, `linear light ${decimals(light)}`, samples > 1 ? `, the mean of ${samples} samples` : '');
  if (index !== null) {
    seen.append(`; entry ${index} of the table, `, swatch(color), ` ${hex(color)}`);
  }
  const count = Object.entries(rays).filter(([, number]) => number > 0).map(([kind, number]) => `${number} ${kind}`);
  const items = tree.map((ray) => {
    const item = element('li', {}, `${ray.kind}: ${ray.text}`);
    item.style.setProperty('--depth', ray.depth);
    if (ray.light.some((register) => register > 0)) {
      item.append(`; brings ${decimals(ray.light)}`);
    }
    if (ray.line !== null) {
      const there = element('button', { className: 'line', textContent: `line ${ray.line}` });
      there.onclick = () => select(ray.line, 1);
      item.append(' ', there);
    }
    return item;
  });
  if (untold > 0) {
    items.push(element('li', { textContent: `and ${untold} more` }));
  }
  $('explanation').replaceChildren(title, seen, element('div', { textContent: `rays: ${count.join(', ')}` }), element('ol', {}, ...items));
}

// The text.

// Puts the cursor at a place of the text.
function select(line, column) {
  const text = $('text');
  const before = text.value.split('\n').slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  text.focus();
  text.setSelectionRange(before + column - 1, before + column - 1);
  text.scrollTop = (line - 5) * (text.scrollHeight / text.value.split('\n').length);
}

function number(wrong) {
  const count = $('text').value.split('\n').length;
  const lines = [];
  for (let line = 1; line <= count; line += 1) {
    lines.push(line === wrong ? element('b', { textContent: line }) : String(line), '\n');
  }
  $('lines').replaceChildren(...lines);
  $('lines').scrollTop = $('text').scrollTop;
}

function place({ line, column }) {
  return line === null || line === undefined ? '' : `line ${line}${column ? `, column ${column}` : ''}: `;
}

function said(className, what) {
  const made = element('div', { className });
  if (what.line) {
    const there = element('button', { className: 'line', textContent: place(what) });
    there.onclick = () => select(what.line, what.column ?? 1);
    made.append(there);
  }
  made.append(what.message);
  return made;
}

// Checking and drawing.

const displays = [];
let shipped = [];
let checker = null;
let checking = false;
let again = false;
let pause;

const request = (name) => {
  const setting = Object.fromEntries(SETTINGS.map((one) => [one, $(one).value]));
  const { size, format, model, depth, table, dither, motion, instant, frames } = setting;
  const time = motion === 'film' ? `frames ${frames}` : `instant ${instant}`;
  return `${name} ${size} ${format} ${model} ${depth} ${table} ${dither} ${time}\n${$('text').value}`;
};

// Has the text checked, and drawn if nothing is wrong with it. What is drawn is what was checked.
function look() {
  clearTimeout(pause);
  pause = undefined;
  if (checking) {
    again = true;
    return;
  }
  checking = true;
  again = false;
  document.body.dataset.state = 'checking';
  const requests = displays.map((display) => request(display.about.name));
  checker.requests = requests;
  checker.postMessage({ job: 0, kind: 'check', request: requests[0] });
}

function checked({ job, checked: fine, failed, choices, kept }) {
  if (choices !== undefined) {
    // A checker that takes the place of another has nothing to offer that is new.
    if (displays.length === 0) {
      offer(choices);
    }
    return;
  }
  if (failed?.ended) {
    checker.terminate();
    checker = worker(checked);
  }
  if (kept !== undefined || (failed && job !== 0)) {
    given(job, kept, failed);
    if (failed?.ended && checking) {
      checking = false;
      look();
    }
    return;
  }
  checking = false;
  if (again) {
    look();
    return;
  }
  // More was typed: what there is to say is out of date.
  if (pause !== undefined) {
    return;
  }
  document.body.dataset.state = failed ? 'wrong' : 'fine';
  $('text').classList.toggle('wrong', failed !== undefined);
  number(failed?.line);
  $('message').replaceChildren(...(failed ? [said('error', failed)] : fine.warnings.map((warning) => said('warning', warning))));
  if (!failed) {
    // What `auto` stands for.
    $('model').options[0].textContent = $('model').value === 'auto' ? `the scene's: ${fine.model}` : "the scene's";
    $('depth').options[0].textContent = $('depth').value === 'auto' ? `the scene's: ${fine.depth}` : "the scene's";
    move(fine.moves);
    displays.forEach((display, index) => display.draw(checker.requests[index]));
  }
}

// Lets instants and films be chosen where something moves, and else says why not.
function move(moves) {
  const film = $('motion').value === 'film';
  $('motion').disabled = !moves;
  $('instant').disabled = !moves || film;
  $('frames').disabled = !moves || !film;
  $('rate').disabled = !moves || !film;
  $('moves').textContent = moves ? '' : 'nothing moves in this scene: it has no path';
}

function play(now) {
  const count = Math.floor((now * Number($('rate').value)) / 1000);
  displays.forEach((display) => display.turn(count));
  requestAnimationFrame(play);
}

// Files: pictures that the scene names, and scenes.

const SCENE = /\.(rta|dat|nff|p3f)$/i;

// Has each picture decoded, and takes the last scene for the text. The job of a picture is its name.
async function take(files) {
  $('given').replaceChildren([...pictures.keys()].join(', '));
  for (const file of files) {
    if (SCENE.test(file.name)) {
      $('text').value = await file.text();
      $('text').scrollTop = 0;
      edited();
    } else {
      const contents = new Uint8Array(await file.arrayBuffer());
      checker.postMessage({ job: file.name, kind: 'picture', name: file.name, contents }, [contents.buffer]);
    }
  }
}

// Hears of a picture: one that a worker has taken because the page has it already, one that is new, or one that failed.
function given(name, kept, failed) {
  if (name === undefined) {
    return;
  }
  if (failed) {
    const message = failed.ended ? `the picture ${name} is broken: ${failed.message}` : failed.message;
    $('given').append(' ', element('span', { className: 'error', textContent: message }));
    return;
  }
  const { contents } = kept;
  pictures.set(name, contents);
  displays.forEach((display) => display.worker?.postMessage({ kind: 'picture', name, contents }));
  const errors = [...$('given').children].flatMap((error) => [' ', error]);
  $('given').replaceChildren([...pictures.keys()].join(', '), ...errors);
  look();
}

// The link: the settings, and the name of a shipped scene or a text, deflated.

async function through(stream, bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

async function pack(text) {
  const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(text));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

async function unpack(packed) {
  const letters = atob(packed.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  return new TextDecoder('utf-8', { fatal: true }).decode(await through(new DecompressionStream('deflate-raw'), bytes));
}

let links = 0;

async function link() {
  links += 1;
  const mine = links;
  const text = $('text').value;
  const words = new URLSearchParams(SETTINGS.map((name) => [name, $(name).value]));
  const scene = shipped.find((one) => one.text === text);
  $('scene').value = scene?.name ?? '';
  if (scene !== undefined) {
    words.set('scene', scene.name);
  } else {
    words.set('text', await pack(text));
  }
  if (mine === links) {
    history.replaceState(null, '', `#${words}`);
    $('link').href = `#${words}`;
  }
}

// Takes settings and scene from the link; what it does not say is as on the first visit.
async function follow() {
  const words = new URLSearchParams(location.hash.slice(1));
  for (const name of SETTINGS) {
    $(name).value = words.get(name) ?? FIRST[name];
    if ($(name).selectedIndex < 0) {
      $(name).value = FIRST[name];
    }
    confine(name);
  }
  let text = (shipped.find(({ name }) => name === words.get('scene')) ?? shipped[0]).text;
  if (words.has('text')) {
    try {
      text = await unpack(words.get('text'));
    } catch {
      $('message').replaceChildren(said('error', { message: 'the link is damaged: it holds no scene' }));
      return;
    }
  }
  $('text').value = text;
  edited();
}

// Makes a number one that the module takes.
function confine(name) {
  const { type, min, max, step } = $(name);
  if (type === 'number') {
    const number = $(name).valueAsNumber;
    const whole = step === '1' ? Math.round(number) : number;
    $(name).value = Number.isNaN(number) ? FIRST[name] : Math.min(Math.max(whole, min), max);
  }
}

function edited() {
  number();
  link();
  look();
}

// The controls.

function options(id, values) {
  $(id).replaceChildren(...values.map(([value, text, title]) => element('option', { value, textContent: text ?? value, title: title ?? '' })));
}

// Fills the page with what the module offers, and begins.
function offer(choices) {
  shipped = choices.scenes;
  const told = ({ name, about }) => [name, name, about];
  options('scene', [['', 'your own'], ...shipped.map(({ name }) => [name])]);
  options('model', [['auto', "the scene's"], ...choices.models.map(told)]);
  options('format', choices.formats.map(told));
  options('depth', [['auto', "the scene's"], ...Array.from({ length: choices.depth + 1 }, (_, depth) => [String(depth)])]);
  options('table', choices.tables.map((name) => [name]));
  options('dither', [['auto', 'what suits'], ...choices.dithers.map((name) => [name])]);
  options('motion', [['still', 'an instant'], ['film', 'a film']]);
  $('frames').max = choices.frames;
  $('rate').max = choices.rate;
  options('size', [['1', 'whole'], ['2', 'half'], ['4', 'a quarter'], ['8', 'an eighth']]);
  for (const about of choices.displays) {
    const display = new Display(about);
    displays.push(display);
    $('displays').append(display.figure);
  }
  SETTINGS.forEach((name) => {
    $(name).onchange = () => {
      confine(name);
      edited();
    };
  });
  $('motion').onchange = () => {
    // A film stops where it is.
    const [{ shown, frames }] = displays;
    if ($('motion').value === 'still' && frames > 1) {
      $('instant').value = shown / frames;
    }
    edited();
  };
  // How quickly a film is shown changes none of its frames.
  $('rate').onchange = () => {
    confine('rate');
    link();
  };
  $('scene').onchange = () => {
    const scene = shipped.find(({ name }) => name === $('scene').value);
    if (scene !== undefined) {
      $('text').value = scene.text;
      $('text').scrollTop = 0;
      edited();
    }
  };
  $('files').onchange = async () => {
    await take([...$('files').files]);
    // So that the same file can be chosen again when it has changed.
    $('files').value = '';
  };
  ondragover = (event) => event.preventDefault();
  ondrop = (event) => {
    event.preventDefault();
    take([...event.dataTransfer.files]);
  };
  $('text').oninput = () => {
    number();
    link();
    document.body.dataset.state = 'typing';
    clearTimeout(pause);
    pause = setTimeout(look, PAUSE);
  };
  $('text').onscroll = () => {
    $('lines').scrollTop = $('text').scrollTop;
  };
  onhashchange = follow;
  follow();
  requestAnimationFrame(play);
}

checker = worker(checked);
