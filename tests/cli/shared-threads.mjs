// Takes the place of `tinypool` and of `Worker` in the shared process of tests/cli/gq.ts, and does the work of all threads in the
// main thread: a thread takes half a second to start, and compiles everything anew. Messages and results are copied as between
// threads. Tests about threads themselves use processes of their own.
import { EventEmitter } from 'node:events';

export class Tinypool {
  constructor({ filename, maxThreads }) {
    this.filename = filename;
    this.threads = maxThreads;
    this.waiting = [];
  }

  run(task) {
    const result = new Promise((resolve, reject) => this.waiting.push({ task: structuredClone(task), resolve, reject }));
    // the tasks of a command arrive together
    this.working ??= Promise.resolve().then(() => this.work());
    return result;
  }

  /** Does one task after the other: with one thread in their order, with several from the last to the first. */
  async work() {
    const { default: perform } = await import(this.filename);
    while (this.waiting.length > 0) {
      const { task, resolve, reject } = this.threads === 1 ? this.waiting.shift() : this.waiting.pop();
      try {
        resolve(structuredClone(await perform(task)));
      } catch (error) {
        reject(error);
      }
    }
    this.working = undefined;
  }

  async destroy() {
    this.waiting = [];
  }
}

/** What a thread of `gq solve` imports from `node:worker_threads`, by its number. */
const insides = new Map();

/** Used by thread-inside.mjs. */
export function insideOf(thread) {
  const inside = insides.get(thread);
  insides.delete(thread);
  return inside;
}

let started = 0;

/** `Worker` for the threads of `gq solve`. */
export class Worker extends EventEmitter {
  constructor(url, { workerData }) {
    super();
    const { port1, port2 } = new MessageChannel();
    this.port = port1;
    port1.on('message', (message) => this.emit('message', message));
    const thread = String(started++);
    insides.set(thread, { parentPort: port2, workerData: structuredClone(workerData) });
    // each has a module of its own
    import(`${url}?thread=${thread}`).catch((error) => this.emit('error', error));
  }

  postMessage(message) {
    this.port.postMessage(message);
  }

  async terminate() {
    this.port.close();
  }
}
