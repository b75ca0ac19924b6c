import { createSimulation, playScript, type Scene, type Simulation } from '../../../engine/index.ts';
import type { Disc, Hold } from '../../../schema/basics/index.ts';
import { playGameAtRandom } from '../../measure/difficulty/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { type Candidate, cutHolds } from '../../verified-run.ts';
import { distance, type Layout } from './layout.ts';
import { PLACED_KINDS, type PlacedList } from './placed.ts';
import { sceneOf } from './scouting.ts';
import { type Image, PLAIN_STAGE, partnerOf, type Stage } from './themes/index.ts';

// Games from the start, and games that leave each known run at a random tick.
const GAMES = 300;
const STRAYS = 200;

// Games are watched for so long, ticks: 25 s, longer than most runs.
const WATCHED = 1500;

/** A game as played, and how it ended. */
interface Game {
  readonly holds: readonly Hold[];
  readonly ending: string;
}

/**
 * Plays games that a level is judged by: at random from the start, and along each of the given runs up to a random tick and at
 * random from there. The known runs come first.
 */
function playGames(scene: Scene, runs: readonly Candidate[], random: Random): Game[] {
  const simulation = createSimulation(scene);
  const scripts: (readonly Hold[])[] = runs.map(({ holds }) => holds);
  for (let i = 0; i < GAMES; i++) scripts.push(playGameAtRandom(simulation, random, WATCHED));
  for (const run of runs) {
    for (let i = 0; i < STRAYS; i++) {
      const leave = random.below(run.tick);
      const tail = randomTail(leave, random);
      scripts.push([...cutHolds(run.holds, leave - 1), ...tail]);
    }
  }
  return scripts.map((holds) => ({ holds, ending: endingOf(simulation, holds) }));
}

function randomTail(from: number, random: Random): Hold[] {
  const tail: Hold[] = [];
  for (let tick = from + 1 + random.below(60); tick < from + 1200; tick += 1 + random.below(120)) {
    const press = tick;
    tick += 1 + random.below(120);
    tail.push([press, tick]);
  }
  return tail;
}

/** How a script ends, in which tick, and with how many minerals. */
function endingOf(simulation: Simulation, holds: readonly Hold[]): string {
  simulation.reset();
  playScript(simulation, holds, WATCHED);
  const { ending } = simulation;
  return `${ending?.outcome ?? 'timeout'} ${ending?.tick ?? 0} ${simulation.mineralCount}`;
}

type List = 'novae' | 'asteroids' | PlacedList;

/** Every object that may be idle: the list that it is in, and its place there. */
function objectsOf(layout: Layout): { list: List; place: unknown }[] {
  const lists: { list: List; turn: number; objects: readonly unknown[] }[] = [
    { list: 'novae', turn: 2, objects: layout.novae },
    { list: 'asteroids', turn: 3, objects: layout.asteroids },
    ...PLACED_KINDS.map(({ list, turn }) => ({ list, turn, objects: layout.placed[list] })),
  ];
  lists.sort((a, b) => a.turn - b.turn);
  return lists.flatMap(({ list, objects }) => objects.map((place) => ({ list, place })));
}

// px between neighbours of one row or ring, at most.
const LINK = 64;

/**
 * The novae that stay or go together with one: those of its row or ring, or else its counterpart by symmetry. Empty if it is not the
 * first of its row, or is gone already.
 */
function belonging(nova: Disc, novae: readonly Disc[], image: Image | null, figures: readonly Disc[]): readonly Disc[] {
  if (!novae.includes(nova)) return [];
  if (!figures.includes(nova)) {
    const other = image === null ? undefined : partnerOf(image, nova, novae);
    return other === undefined || other === nova || figures.includes(other) ? [nova] : [nova, other];
  }
  const row = [nova];
  for (const one of row) {
    const isNext = (other: Disc) => !row.includes(other) && other.radius === one.radius && distance(other, one) <= LINK;
    row.push(...novae.filter((other) => figures.includes(other) && isNext(other)));
  }
  const first = novae.find((other) => row.includes(other));
  return first === nova ? row : [];
}

/** The layout without one object. */
function without(layout: Layout, list: List, object: unknown): Layout {
  if (list in layout.placed) {
    const placed = layout.placed[list as PlacedList] as readonly unknown[];
    return { ...layout, placed: { ...layout.placed, [list]: placed.filter((other) => other !== object) } };
  }
  return { ...layout, [list]: (layout[list as 'novae'] as readonly unknown[]).filter((other) => other !== object) };
}

/**
 * Removes idle objects: those without which every game ends as before, in the same tick. The games are the known runs and some
 * hundred random ones ({@link playGames}). So what is removed neither helps a run nor kills in any of them.
 * @param stage a nova and its counterpart by symmetry stay or go together, and so do the novae of one row or ring that a theme has
 *   composed; what it keeps is one with a mineral, and stays with it
 * @returns the leaner layout, and the ticks simulated
 */
export function withoutIdle(
  layout: Layout,
  runs: readonly Candidate[],
  seed: number,
  { image, figures, kept }: Stage = PLAIN_STAGE,
): { layout: Layout; ticks: number } {
  const games = playGames(sceneOf(layout), runs, createRandom(seed));
  let ticks = games.length * 500;
  let lean = layout;
  for (const { list, place } of objectsOf(layout)) {
    if (kept.includes(place as Disc)) continue;
    const together =
      list === 'novae'
        ? belonging(
            place as Disc,
            lean.novae.filter((nova) => !kept.includes(nova)),
            image,
            figures,
          )
        : [place];
    // the others of its row have been tried with the first of them
    if (together.length === 0) continue;
    const candidate = together.reduce<Layout>((left, object) => without(left, list, object), lean);
    if (candidate.asteroids.length === 0) continue;
    const simulation = createSimulation(sceneOf(candidate));
    const isIdle = games.every(({ holds, ending }) => {
      const same = endingOf(simulation, holds) === ending;
      ticks += simulation.tick;
      return same;
    });
    if (isIdle) lean = candidate;
  }
  return { layout: lean, ticks };
}
