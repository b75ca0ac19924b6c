// Gives gq the threads of the shared process of tests/cli/gq.ts: see shared-threads.mjs.

const SHARED = new URL('./shared-threads.mjs', import.meta.url).href;
const INSIDE = new URL('./thread-inside.mjs', import.meta.url).href;
const BUNDLE = new URL('../../dist/gq/', import.meta.url).href;

export function resolve(name, context, next) {
  const from = context.parentURL ?? '';
  // gq loads `tinypool` only when it needs threads
  if (name === 'tinypool') return { url: SHARED, shortCircuit: true };
  if (name === 'node:worker_threads') {
    const [, thread] = /\?thread=(\d+)$/.exec(from) ?? [];
    if (thread !== undefined) return { url: `${INSIDE}?thread=${thread}`, shortCircuit: true };
    if (from.startsWith(BUNDLE)) return { url: SHARED, shortCircuit: true };
  }
  return next(name, context);
}
