import { ACCURACIES, compile, simulate } from '../engine/index.ts';
import { KINDS, type Level, LISTED_KINDS, type ObjectKind } from '../schema/index.ts';

const objectsIn = (l: any, k: any): any[] => l[(KINDS as any)[k].list] ?? [];

import { applyChange, createRetime, type ObjectRef, verifyRun } from '../solver/index.ts';
import { askedLevels } from './levels.ts';

const SIZES = [4, 8, 16, 32];
const EFFORT = Number(process.argv[2] ?? 1_000_000);
const DIRS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
];

const refs = (level: Level): ObjectRef[] => [
  { kind: 'astronaut', index: 0 },
  { kind: 'blackHole', index: 0 },
  ...LISTED_KINDS.flatMap((kind) => objectsIn(level, kind).map((_: any, index: number) => ({ kind: kind as ObjectKind, index }))),
];
void KINDS;
void ACCURACIES;
const table = new Map<
  number,
  { broken: number; alive: number; full: number; ticks: number[]; first: number[]; fails: string[] }
>();
for (const size of SIZES) table.set(size, { broken: 0, alive: 0, full: 0, ticks: [], first: [], fails: [] });
for (const { name, level } of askedLevels()) {
  const { holds } = level.runs[0];
  const before = verifyRun(compile(level), holds)!;
  for (const object of refs(level)) {
    if (object.kind === 'mineral') continue;
    for (const size of SIZES)
      for (const [dx, dy] of DIRS) {
        const { list } = KINDS[object.kind];
        const o = list === null ? (level as any)[object.kind] : (level as any)[list][object.index];
        const moved = applyChange(level, { what: 'move', object, from: o, to: { x: o.x + size * dx, y: o.y + size * dy } });
        const scene = compile(moved);
        const after = verifyRun(scene, holds);
        if (after !== null && after.time > 0) continue;
        const row = table.get(size)!;
        row.broken++;
        const retime = createRetime(scene, holds, { minerals: before.minerals, formerEnd: before.tick });
        let first = 0;
        while (!retime.finished && retime.effort.ticks < EFFORT) {
          retime.advance(2000);
          if (first === 0 && retime.best) first = retime.effort.ticks;
        }
        if (retime.best === null) {
          row.fails.push(`${name} ${object.kind} ${object.index} ${size * dx},${size * dy} ${simulate(scene, holds).outcome}`);
          row.ticks.push(retime.effort.ticks);
          continue;
        }
        row.alive++;
        row.first.push(first);
        row.ticks.push(retime.effort.ticks);
        if (retime.best.lost.length === 0) row.full++;
      }
  }
}
const q = (v: number[], p: number) => v.sort((a, b) => a - b)[Math.floor(p * (v.length - 1))];
for (const [size, r] of table) {
  console.log(
    size,
    'broken',
    r.broken,
    'alive',
    r.alive,
    'full',
    r.full,
    'first',
    q(r.first, 0.5),
    q(r.first, 0.95),
    'ticks',
    q(r.ticks, 0.5),
    q(r.ticks, 0.95),
  );
  for (const f of r.fails) console.log('   ', f);
}
