// A worker with a module of its own: it checks a scene, or draws one, as a picture or as the frames of a film, and explains its pixels.
//
// Messages in: { module } first; then { job, kind: 'check' | 'start', request } with the text that the module reads,
// { job, kind: 'explain', x, y }, or { job, kind: 'picture', name, contents } with a picture file. Messages out: { choices } first; then { job }
// with one of checked, started, rows, done, explained, kept and failed.

// Rows are sent when so many milliseconds have passed: the page shows them, and the worker reads its messages.
const SLICE = 40;

let module;
let loaded;
const turn = new MessageChannel();
let next = () => {};
turn.port1.onmessage = () => next();

const memory = (address, length) => new Uint8Array(module.memory.buffer, address, length);
const bytes = () => memory(module.output(), module.output_len()).slice();
const parsed = (answer) => JSON.parse(new TextDecoder().decode(answer));
const json = () => parsed(bytes());

// Throws the answer of a call that failed.
function answered(status) {
  if (status !== 0) {
    throw json();
  }
}

// Writes a request and has it answered.
function ask(name, request, contents = []) {
  const text = new TextEncoder().encode(request);
  const address = module.alloc(text.length + contents.length);
  const input = memory(address, text.length + contents.length);
  input.set(text);
  input.set(contents, text.length);
  answered(module[name]());
  return bytes();
}

// Does the rest of the drawing after the messages that wait.
function later(job, act) {
  next = () => guarded(job, act);
  turn.port2.postMessage(null);
}

// Draws rows of a frame from `first` on for a while; a picture is a film of one frame.
function draw(job, film, frame, first) {
  const { width, height, frames } = film;
  const end = performance.now() + SLICE;
  if (first === 0 && frame > 0) {
    answered(module.frame(frame));
  }
  const rows = [];
  do {
    answered(module.row(first + rows.length));
    rows.push(bytes());
  } while (first + rows.length < height && performance.now() < end);
  const indices = new Uint8Array(rows.length * width);
  rows.forEach((row, index) => indices.set(row, index * width));
  answered(module.colors());
  const colors = bytes();
  postMessage({ job, rows: { frame, first, indices, colors } }, [indices.buffer, colors.buffer]);
  const next = first + rows.length;
  if (next < height) {
    later(job, () => draw(job, film, frame, next));
  } else if (frame + 1 < frames) {
    later(job, () => draw(job, film, frame + 1, 0));
  } else {
    postMessage({ job, done: true });
  }
}

// Tells what goes wrong: an error of the module, or its end, after which it is of no more use.
function guarded(job, act, kind = 'draw') {
  try {
    act();
  } catch (error) {
    const ended = error instanceof Error;
    const message = ended ? `the module has ended: ${error.message}` : error.message;
    postMessage({ job, failed: { ...error, message, ended, kind } });
  }
}

const kinds = {
  check({ job, request }) {
    postMessage({ job, checked: parsed(ask('check', request)) });
  },
  start({ job, request }) {
    next = () => {};
    const started = parsed(ask('start', request));
    postMessage({ job, started });
    later(job, () => draw(job, started, 0, 0));
  },
  picture({ job, name, contents }) {
    const ppm = ask('picture_file', `${name}\n`, contents);
    postMessage({ job, kept: { name, contents: ppm } });
  },
  explain({ job, x, y }) {
    answered(module.explain(x, y));
    postMessage({ job, explained: { x, y, ...json() } });
  },
};

onmessage = ({ data }) => {
  if (data.module !== undefined) {
    loaded = WebAssembly.instantiate(data.module).then((instance) => {
      module = instance.exports;
      answered(module.choices());
      postMessage({ choices: json() });
    });
  } else {
    loaded.then(() => guarded(data.job, () => kinds[data.kind](data), data.kind));
  }
};
