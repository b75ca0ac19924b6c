import { expect, it } from 'vitest';
import { runInPool } from '../../cli/io/pool.ts';

const module = (source: string): URL => new URL(`data:text/javascript,${encodeURIComponent(source)}`);

it('gives one result for each task in the order of the tasks, and reports each as it ends', async () => {
  // task n waits until n tasks have been reported
  const inTurn = module(`export default ({ turn, shared }) => {
    const told = new Int32Array(shared);
    for (let count = 0; (count = Atomics.load(told, 0)) !== turn; ) Atomics.wait(told, 0, count);
    return turn;
  }`);
  const shared = new SharedArrayBuffer(4);
  const tasks = [2, 0, 1].map((turn) => ({ turn, shared }));
  const told: [number, number][] = [];
  const results = await runInPool<(typeof tasks)[number], number>(inTurn, tasks, 3, (done, turn) => {
    told.push([done, turn]);
    Atomics.add(new Int32Array(shared), 0, 1);
    Atomics.notify(new Int32Array(shared), 0);
  });
  expect(results).toEqual([2, 0, 1]);
  expect(told).toEqual([
    [1, 0],
    [2, 1],
    [3, 2],
  ]);
});

it('rejects with the error of a task or of the callback, while others go on', async () => {
  const endless = module('export default (n) => n === 1 ? n : new Promise(() => {})');
  const told = runInPool<number, number>(endless, [1, 2, 3], 2, async () => {
    throw new Error('told');
  });
  await expect(told).rejects.toThrow('told');
  const failing = module('export default (n) => { if (n === 1) throw new Error("task"); return new Promise(() => {}); }');
  await expect(runInPool<number, number>(failing, [1, 2], 2, () => {})).rejects.toThrow('task');
});
