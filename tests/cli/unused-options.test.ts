import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { gq } from './gq.ts';

const cwd = fileURLToPath(new URL('./fixtures', import.meta.url));
const LEVEL = 'levels/01-through.level.json';

describe('an option that would have no effect is refused', () => {
  it.each([
    [`check ${LEVEL} --seed 3`, '--seed has no effect without --solve: give --solve as well, or leave --seed out'],
    [`check ${LEVEL} --seed 0`, '--seed has no effect without --solve'],
    [`tune ${LEVEL} --set pull=1.1x --seed 3`, '--seed has no effect without --solve'],
    [`tune ${LEVEL} --set pull=1.1x --theme dark`, '--theme has no effect without --svg'],
    [`difficulty ${LEVEL} --theme auto`, '--theme has no effect without --svg'],
    [`accuracy ${LEVEL} --theme light`, '--theme has no effect without --svg'],
    [`render ${LEVEL} -o - --no-run --run x`, '--run and --no-run cannot be combined: give one of the two'],
    [`render ${LEVEL} -o - --run x --no-run`, '--run and --no-run cannot be combined: give one of the two'],
    [`render ${LEVEL} -o - --no-run --all-runs`, '--no-run and --all-runs cannot be combined'],
    [`render ${LEVEL} -o - --no-run --solve 2`, '--no-run and --solve cannot be combined'],
    [`render ${LEVEL} -o - --no-run --closest`, '--no-run and --closest cannot be combined'],
    [`render ${LEVEL} -o - --no-run --explored --closest`, '--no-run and --explored with --closest cannot be combined'],
    [`render ${LEVEL} -o - --no-run --proof`, '--no-run and --proof cannot be combined'],
    [`render ${LEVEL} -o - --effort 100`, '--effort has no effect without --solve, --explored, --closest or --softlocks'],
    [`render ${LEVEL} -o - --fan 2 --effort 100`, '--effort has no effect without --solve, --explored, --closest or --softlocks'],
    [`render ${LEVEL} -o - --seed 1`, '--seed has no effect without --solve, --explored, --closest, --softlocks or --fan'],
    [`render ${LEVEL} -o - --minerals all`, '--minerals has no effect without --solve, --explored, --closest or --proof'],
  ])('gq %s', async (args, message) => {
    const ended = await gq(args.split(' '), { cwd });
    expect(ended).toMatchObject({ code: 2, stdout: '' });
    expect(ended.stderr).toContain(`error: ${message}`);
  });

  it.each([
    `render ${LEVEL} -o - --no-run`,
    `render ${LEVEL} -o - --fan 1 --seed 1`,
    `render ${LEVEL} -o - --no-run --explored --effort 1000 --seed 1 --minerals any`,
  ])('gq %s is done', async (args) => {
    expect(await gq(args.split(' '), { cwd })).toMatchObject({ code: 0, stderr: '' });
  });
});
