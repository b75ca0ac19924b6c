import { expect, it } from 'vitest';
import { runInPool } from '../../cli/pool.ts';

const module = (source: string): URL => new URL(`data:text/javascript,${encodeURIComponent(source)}`);

it('gives one result a task in the order of the tasks, and tells of each as it ends', async () => {
  const later = module('export default (ms) => new Promise((resolve) => setTimeout(resolve, ms, ms))');
  const told: [number, number][] = [];
  const results = await runInPool<number, number>(later, [300, 1, 2], 3, (done, ms) => void told.push([done, ms]));
  expect(results).toEqual([300, 1, 2]);
  expect(told.map(([done]) => done)).toEqual([1, 2, 3]);
  expect(told[2]).toEqual([3, 300]);
});

it('ends with what a task throws, or who is told of it, while others go on', async () => {
  const endless = module('export default (n) => n === 1 ? n : new Promise((resolve) => setTimeout(resolve, 1e6))');
  const told = runInPool<number, number>(endless, [1, 2, 3], 2, async () => {
    throw new Error('told');
  });
  await expect(told).rejects.toThrow('told');
  const failing = module('export default (n) => { if (n === 1) throw new Error("task"); return new Promise(() => {}); }');
  await expect(runInPool<number, number>(failing, [1, 2], 2, () => {})).rejects.toThrow('task');
});
