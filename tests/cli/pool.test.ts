import { expect, it } from 'vitest';
import { runInPool } from '../../cli/pool.ts';

// a task that takes as long as the test is given
const ENDLESS = new URL('data:text/javascript,export default () => new Promise((resolve) => setTimeout(resolve, 1e6))');

it.each(['before it begins', 'as it begins', 'later'])('ends when it is stopped %s', async (when) => {
  const stopped = new AbortController();
  if (when === 'before it begins') stopped.abort();
  const work = runInPool<number, void>(ENDLESS, [1, 2, 3], 2, { stop: stopped.signal, onDone: () => {} });
  if (when === 'as it begins') stopped.abort();
  if (when === 'later') setTimeout(() => stopped.abort(), 100);
  expect(await work).toEqual([]);
});
