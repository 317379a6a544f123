// node run.mjs MODULE FOLDER: draws the picture, writes FOLDER/colors.raw and FOLDER/pixels.raw.
// Exit codes: 0, 2 for a display error, 99 for a trap, 101 for a panic.
import fs from 'node:fs';
import path from 'node:path';

const [modulePath, folder] = process.argv.slice(2);
if (folder === undefined) {
  console.error('usage: node run.mjs MODULE FOLDER');
  process.exit(64);
}

const { instance } = await WebAssembly.instantiate(fs.readFileSync(modulePath));
const board = instance.exports;

let status;
try {
  status = board.draw();
} catch (error) {
  if (!(error instanceof WebAssembly.RuntimeError)) {
    throw error;
  }
  console.error(error.message);
  // A panic is the instruction `unreachable`; V8 says no more of it than this.
  process.exit(error.message === 'unreachable' ? 101 : 99);
}

// The memory is looked at after drawing: growing it would have detached an earlier view.
const bytes = (address, length) => Buffer.from(board.memory.buffer, address, length);
fs.writeFileSync(path.join(folder, 'colors.raw'), bytes(board.colors(), board.colors_len()));
fs.writeFileSync(path.join(folder, 'pixels.raw'), bytes(board.pixels(), board.pixels_len()));
process.exit(status);
