// Takes the place of `tinypool` in the shared process of tests/cli/gq.ts: the threads of a command serve the next one, too, because
// each costs half a second to start. What ends the threads of a command is tested in processes of their own.
import { Tinypool as Pool } from 'tinypool';

const pools = new Map();

function poolOf(options) {
  const key = JSON.stringify(options);
  if (!pools.has(key)) pools.set(key, new Pool(options));
  return pools.get(key);
}

export class Tinypool {
  constructor(options) {
    this.pool = poolOf(options);
  }

  run(task) {
    return this.pool.run(task);
  }

  async destroy() {
    // the next command uses the threads
  }
}
