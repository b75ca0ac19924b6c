import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { playableLevel } from '../tests/scenes/playable-level.ts';
import * as interactions from './editor/interactions.ts';
import { openStage } from './editor/stage.ts';
import { type Cost, p95 } from './editor/trace.ts';
import { atMost, type Claim, optionValue, publish, spread } from './harness.ts';

/** Steps of a drag, a scrub or a marquee. */
const STEPS = Number(optionValue('--steps') ?? 60);
/** How often a single action is repeated. */
const TIMES = Number(optionValue('--times') ?? 20);
/** How often a gesture that is measured frame by frame is repeated: its figure is the median of as many 95th percentiles. */
const ROUNDS = Number(optionValue('--rounds') ?? 3);
const SIZES = (optionValue('--objects') ?? '30,1000,5000').split(',').map(Number);

/** Size of everything the page loads before it can be used, gzipped, kB. */
function firstLoad(): number {
  const folder = fileURLToPath(new URL('../editor/', import.meta.url));
  const html = readFileSync(`${folder}index.html`, 'utf8');
  const asked = [...html.matchAll(/(?:src|href)="\.\/([^"]+)"/g)].map(([, path]) => path);
  const assets = readdirSync(`${folder}assets`).map((file) => `assets/${file}`);
  if (asked.length < 2 || !assets.some((path) => asked.includes(path)))
    throw new Error('the page names no assets: was it built?');
  return ['index.html', ...asked].reduce((sum, path) => sum + gzipSync(readFileSync(folder + path)).length, 0) / 1000;
}

interface Row {
  readonly what: string;
  /** Limit of the 95th percentile, ms. */
  readonly limit: number;
  readonly script: number | null;
  readonly frame: number;
  readonly count: number;
}

/** Another program that wakes up in between spoils a round, not the figure. */
async function inRounds(what: string, limit: number, act: () => Promise<readonly Cost[]>): Promise<Row> {
  const rounds: Row[] = [];
  for (let round = 0; round < ROUNDS; round++) rounds.push(ofCosts(what, limit, await act()));
  const of = (pick: (row: Row) => number) => spread(rounds.map(pick)).median;
  return {
    what,
    limit,
    script: of(({ script }) => script ?? 0),
    frame: of(({ frame }) => frame),
    count: rounds.reduce((sum, { count }) => sum + count, 0),
  };
}

const ofCosts = (what: string, limit: number, costs: readonly Cost[]): Row => ({
  what,
  limit,
  script: p95(costs.map(({ script }) => script)),
  frame: p95(costs.map(({ frame }) => frame)),
  count: costs.length,
});
const ofTimes = (what: string, limit: number, times: readonly number[]): Row => ({
  what,
  limit,
  script: null,
  frame: p95(times),
  count: times.length,
});

/** Adds its results to `rows` one by one, so that they remain if a later measurement fails. */
async function measure(objects: number, rows: Row[]): Promise<void> {
  const level = playableLevel(objects);
  const names = ['To', 'Fro'] as const;
  const stage = await openStage({ '01': { ...level, name: names[0] }, '02': { ...level, name: names[1] } });
  const places = [
    level.astronaut,
    level.blackHole,
    ...(level.asteroids ?? []),
    ...(level.novae ?? []),
    ...(level.minerals ?? []),
  ];
  const all = [...places, ...(level.repulsors ?? []), ...(level.aliens ?? [])];
  const reach = (place: { x: number; y: number }) => ('radius' in place ? Number(place.radius) : 16);
  const extent = {
    left: Math.min(...all.map((place) => place.x - ('radius' in place ? Number(place.radius) : 10))),
    top: Math.min(...all.map((place) => place.y - reach(place))),
    right: Math.max(...all.map((place) => place.x + ('radius' in place ? Number(place.radius) : 10))),
    bottom: Math.max(...all.map((place) => place.y + reach(place))),
  };
  const grip = (level.asteroids ?? []).filter(({ y }) => y < 0).at(0) ?? level.astronaut;
  // the measurement takes minutes, so intermediate results are shown
  const say = (what: string) => {
    const last = rows.at(-1);
    const known =
      last === undefined ? '' : `${last.what}: script ${last.script?.toFixed(1) ?? '-'}, frame ${last.frame.toFixed(1)} ms; `;
    process.stderr.write(`${objects} objects: ${known}now ${what}\n`);
  };
  try {
    say('rest');
    rows.push(ofTimes('the main thread in a second at rest', 600, await interactions.rest(stage, 5)));
    say('drag');
    rows.push(await inRounds('drag with ghost and verdict', 33, () => interactions.drag(stage, extent, STEPS)));
    say('scrub');
    rows.push(await inRounds('scrub', 16, () => interactions.scrub(stage, STEPS)));
    say('undo');
    rows.push(ofCosts('undo with re-check', 50, await interactions.undo(stage, extent, 2 * TIMES)));
    say('toDisk');
    rows.push(ofTimes('on disk after the last edit', 1000, await interactions.toDisk(stage, '01', extent, TIMES)));
    say('marquee');
    rows.push(await inRounds('marquee over half of them, a frame', 33, () => interactions.marquee(stage, extent, STEPS)));
    say('dragMany');
    // half of thousands are 2,500 objects, which all move, and the run with them: it is simulated in each frame
    const many = objects > 1000 ? 66 : 33;
    const grab = [grip.x, grip.y] as const;
    rows.push(await inRounds('drag half of them, a frame', many, () => interactions.dragMany(stage, extent, grab, STEPS)));
    say('zoomAll');
    rows.push(await inRounds('zoom with all selected, a frame', 33, () => interactions.zoomAll(stage, extent, STEPS)));
    say('panAll');
    rows.push(await inRounds('pan with all selected, a frame', 33, () => interactions.panAll(stage, extent, STEPS)));
    say('enterPlay');
    rows.push(ofCosts('entering play', 100, await interactions.enterPlay(stage, TIMES)));
    say('switchLevel');
    // with thousands of objects, a person accepts to wait a second
    rows.push(
      ofCosts(
        'switching level',
        objects > 1000 ? 1000 : 300,
        await interactions.switchLevel(stage, names, 2 * Math.ceil(TIMES / 2)),
      ),
    );
    say('fan');
    rows.push(ofTimes('fan after a drag', 500, await interactions.fan(stage, extent, TIMES)));
    if (objects <= 30) {
      // the run of a larger level takes too much work to be simulated at hundreds of places within that time
      say('leeway');
      const [first, ...later] = await interactions.leeway(stage, extent, TIMES + 1);
      // the first time, its worker starts
      rows.push(ofTimes('where may it stand, the very first shade', 1500, [first]));
      rows.push(ofTimes('where may it stand, the first shade', 500, later));
    }
    say('search');
    const { first, cancel } = await interactions.search(stage, TIMES);
    rows.push(ofTimes('first word from a search', 1500, first), ofCosts('cancelling it', 50, cancel));
    say('openPage');
    rows.push(ofTimes('opening the page', objects > 1000 ? 2500 : 1500, await interactions.openPage(stage, TIMES)));
  } finally {
    await stage.close();
  }
}

const load = firstLoad();
const rows: (string | number | null)[][] = [];
const claims: Claim[] = [atMost('first load, gzipped, kB', load, 1500)];
for (const objects of SIZES) {
  const measured: Row[] = [];
  await measure(objects, measured).catch((error) => {
    process.exitCode = 1;
    console.error(
      `${objects} objects: it broke off after ${measured.length} rows: ${error instanceof Error ? error.message : error}`,
    );
  });
  for (const { what, limit, script, frame, count } of measured) {
    rows.push([what, objects, count, script, frame, limit]);
    claims.push(atMost(`${what}, ${objects} objects, ms`, script ?? frame, limit));
  }
}
publish({
  title: 'The editor in Chromium: what 95 of 100 take at most, ms',
  columns: ['', 'objects', 'times', 'script', 'until the frame', 'limit'],
  rows,
  claims,
  notes: [
    'Script: processor time of the main thread from the input to the work for the next frame, read from a trace of the browser; claims are about it where it is there.',
    'At rest, only decorations move; the figure is all work of the main thread, by the clock.',
    'Until the frame: by the clock, until the frame was handed to the painter. Chromium runs without a graphics card here: the processor copies and paints the whole canvas.',
    `First load: ${load.toFixed(0)} kB gzipped, Phaser included.`,
  ],
});
