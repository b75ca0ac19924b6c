import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { playableLevel } from '../tests/scenes/playable-level.ts';
import * as interactions from './editor/interactions.ts';
import { openStage, type Stage } from './editor/stage.ts';
import type { Cost } from './editor/trace.ts';
import { atMost, define, median, nearestRank, number, numbers, PROJECT, sum } from './harness/index.ts';

/** Size of everything the page loads before it can be used, gzipped, kB. */
function firstLoad(): number {
  const folder = join(PROJECT, 'dist/editor');
  const html = readFileSync(join(folder, 'index.html'), 'utf8');
  const asked = [...html.matchAll(/(?:src|href)="\.\/([^"]+)"/g)].map(([, path]) => path);
  const assets = readdirSync(join(folder, 'assets')).map((file) => `assets/${file}`);
  if (asked.length < 2 || !assets.some((path) => asked.includes(path)))
    throw new Error('the page names no assets: was it built?');
  return sum(['index.html', ...asked].map((path) => gzipSync(readFileSync(join(folder, path))).length)) / 1000;
}

/** More objects than this may take longer in some rows. */
const MANY = 1000;

/** Limits of the 95th percentiles, ms; the second ones are for more than 1,000 objects. */
const LIMITS = {
  rest: atMost(600, 'the main thread in a second at rest'),
  drag: atMost(33, 'drag with ghost and verdict'),
  scrub: atMost(16, 'scrub'),
  undo: atMost(50, 'undo with re-check'),
  toDisk: atMost(1000, 'on disk after the last edit'),
  marquee: atMost(33, 'marquee over half of them, a frame'),
  dragMany: atMost(33, 'drag half of them, a frame'),
  // half of thousands are 2,500 objects, which all move, and the run with them: it is simulated in each frame
  dragManyOf: atMost(66, 'drag half of them, a frame'),
  zoomAll: atMost(33, 'zoom with all selected, a frame'),
  panAll: atMost(33, 'pan with all selected, a frame'),
  enterPlay: atMost(100, 'entering play'),
  switchLevel: atMost(300, 'switching level'),
  // with thousands of objects, a person accepts to wait a second
  switchLevelOf: atMost(1000, 'switching level'),
  fan: atMost(500, 'fan after a drag'),
  // the first time, its worker starts
  leewayFirst: atMost(1500, 'where may it stand, the very first shade'),
  leeway: atMost(500, 'where may it stand, the first shade'),
  search: atMost(1500, 'first word from a search'),
  cancel: atMost(50, 'cancelling it'),
  openPage: atMost(1500, 'opening the page'),
  openPageOf: atMost(2500, 'opening the page'),
};
type Measured = keyof typeof LIMITS;

interface Row {
  readonly what: Measured;
  readonly script: number | null;
  readonly frame: number;
  readonly count: number;
}

const p95 = (values: readonly number[]): number => nearestRank(values, 0.95);

const ofCosts = (what: Measured, costs: readonly Cost[]): Row => ({
  what,
  script: p95(costs.map(({ script }) => script)),
  frame: p95(costs.map(({ frame }) => frame)),
  count: costs.length,
});
const ofTimes = (what: Measured, times: readonly number[]): Row => ({
  what,
  script: null,
  frame: p95(times),
  count: times.length,
});

interface Asked {
  readonly steps: number;
  readonly times: number;
  readonly rounds: number;
}

const NAMES = ['To', 'Fro'] as const;

/** Everything that is done with a level of so many objects, in turn; each is done when the one before has been noted. */
async function* actions(stage: Stage, level: ReturnType<typeof playableLevel>, objects: number, { steps, times, rounds }: Asked) {
  const { asteroids = [], novae = [], minerals = [], repulsors = [], aliens = [] } = level;
  const all = [level.astronaut, level.blackHole, ...asteroids, ...novae, ...minerals, ...repulsors, ...aliens];
  const across = (place: { x: number; y: number }, otherwise: number) => ('radius' in place ? Number(place.radius) : otherwise);
  const extent = {
    left: Math.min(...all.map((place) => place.x - across(place, 10))),
    top: Math.min(...all.map((place) => place.y - across(place, 16))),
    right: Math.max(...all.map((place) => place.x + across(place, 10))),
    bottom: Math.max(...all.map((place) => place.y + across(place, 16))),
  };
  const grip = asteroids.find(({ y }) => y < 0) ?? level.astronaut;
  /** Another program that wakes up in between spoils a round, not the figure. */
  const inRounds = async (what: Measured, act: () => Promise<readonly Cost[]>): Promise<Row> => {
    const done: Row[] = [];
    for (let round = 0; round < rounds; round++) done.push(ofCosts(what, await act()));
    const of = (pick: (row: Row) => number) => median(done.map(pick));
    const count = sum(done.map((row) => row.count));
    return { what, script: of(({ script }) => script ?? 0), frame: of(({ frame }) => frame), count };
  };
  const sized = <S extends Measured, L extends Measured>(small: S, large: L): S | L => (objects > MANY ? large : small);
  yield ofTimes('rest', await interactions.rest(stage, 5));
  yield await inRounds('drag', () => interactions.drag(stage, extent, steps));
  yield await inRounds('scrub', () => interactions.scrub(stage, steps));
  yield ofCosts('undo', await interactions.undo(stage, extent, 2 * times));
  yield ofTimes('toDisk', await interactions.toDisk(stage, '01', extent, times));
  yield await inRounds('marquee', () => interactions.marquee(stage, extent, steps));
  const grab = [grip.x, grip.y] as const;
  yield await inRounds(sized('dragMany', 'dragManyOf'), () => interactions.dragMany(stage, extent, grab, steps));
  yield await inRounds('zoomAll', () => interactions.zoomAll(stage, extent, steps));
  yield await inRounds('panAll', () => interactions.panAll(stage, extent, steps));
  yield ofCosts('enterPlay', await interactions.enterPlay(stage, times));
  const switches = 2 * Math.ceil(times / 2);
  yield ofCosts(sized('switchLevel', 'switchLevelOf'), await interactions.switchLevel(stage, NAMES, switches));
  yield ofTimes('fan', await interactions.fan(stage, extent, times));
  if (objects <= 30) {
    // the run of a larger level takes too much work to be simulated at hundreds of places within that time
    const [first, ...later] = await interactions.leeway(stage, extent, times + 1);
    yield ofTimes('leewayFirst', [first]);
    yield ofTimes('leeway', later);
  }
  const { first, cancel } = await interactions.search(stage, times);
  yield ofTimes('search', first);
  yield ofCosts('cancel', cancel);
  yield ofTimes(sized('openPage', 'openPageOf'), await interactions.openPage(stage, times));
}

/** Adds its results to `rows` one by one, so that they remain if a later measurement fails. */
async function measure(objects: number, asked: Asked, rows: Row[]): Promise<void> {
  const level = playableLevel(objects);
  const stage = await openStage({ '01': { ...level, name: NAMES[0] }, '02': { ...level, name: NAMES[1] } });
  try {
    for await (const row of actions(stage, level, objects, asked)) {
      rows.push(row);
      // the measurement takes minutes, so intermediate results are shown
      const { what, script, frame } = row;
      process.stderr.write(
        `${objects} objects: ${LIMITS[what].what}: script ${script?.toFixed(1) ?? '-'}, frame ${frame.toFixed(1)} ms\n`,
      );
    }
  } finally {
    await stage.close();
  }
}

export const bench = define({
  what: 'what a drag, an undo, a search cost in the page, with 30, 1,000 and 5,000 objects; some minutes (needs Chromium)',
  options: {
    objects: numbers([30, 1000, 5000], 'objects of the levels'),
    steps: number(60, 'steps of a drag, a scrub or a marquee'),
    times: number(20, 'how often a single action is repeated'),
    rounds: number(
      3,
      'how often a gesture that is measured frame by frame is repeated; the median of its 95th percentiles counts',
    ),
  },
  claims: { load: atMost(1500, 'first load, gzipped, kB'), broken: atMost(0, 'sizes that could not be measured'), ...LIMITS },
  async run({ objects: sizes, ...asked }) {
    const load = firstLoad();
    const rows: (string | number | null)[][] = [];
    const found = Object.fromEntries(Object.keys(LIMITS).map((key) => [key, {}])) as Record<Measured, Record<string, number>>;
    let broken = 0;
    for (const objects of sizes) {
      const measured: Row[] = [];
      await measure(objects, asked, measured).catch((error) => {
        broken++;
        console.error(
          `${objects} objects: it broke off after ${measured.length} rows: ${error instanceof Error ? error.message : error}`,
        );
      });
      for (const { what, script, frame, count } of measured) {
        rows.push([LIMITS[what].what, objects, count, script, frame, LIMITS[what].limit]);
        found[what][`${objects} objects`] = script ?? frame;
      }
    }
    return {
      title: 'The editor in Chromium: what 95 of 100 take at most, ms',
      columns: ['', 'objects', 'times', 'script', 'until the frame', 'limit'],
      rows,
      measured: { load, broken, ...found },
      notes: [
        'Script: processor time of the main thread from the input to the work for the next frame, read from a trace of the browser; claims are about it where it is there.',
        'At rest, only decorations move; the figure is all work of the main thread, by the clock.',
        'Until the frame: by the clock, until the frame was handed to the painter. Chromium runs without a graphics card here: the processor copies and paints the whole canvas.',
        `First load: ${load.toFixed(0)} kB gzipped, Phaser included.`,
      ],
    };
  },
});
