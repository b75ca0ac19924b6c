import { KINDS, kindOfList, type LevelFile, OBJECT_LISTS } from '../../../schema/index.ts';
import { placesOf } from '../../core/document/index.ts';

/** What a level from a link contains, in words, before it is added. */
export interface LinkSurvey {
  /** `3 asteroids, 1 run with 4 holds` */
  readonly counts: string;
  /** size of its file */
  readonly size: string;
  readonly warnings: readonly string[];
}

/** From these numbers on, the page may become slow. */
const MANY = { objects: 2000, aliens: 200, runs: 50, holds: 2000 } as const;
/** Objects farther out than this are probably a mistake, px. */
const FAR = 1e6;

const count = (number: number, [one, many]: readonly [string, string]): string =>
  `${number.toLocaleString('en')} ${number === 1 ? one : many}`;

/** @param text the text of the level file */
export function surveyLink(file: LevelFile, text: string): LinkSurvey {
  const lists = OBJECT_LISTS.map((list) => {
    const kind = kindOfList(list);
    const objects: readonly { x: number; y: number }[] = file[list] ?? [];
    return { kind, objects };
  });
  const runs = file.runs ?? [];
  const holds = runs.reduce((sum, run) => sum + run.holds.length, 0);
  const rules = Object.keys(file.rules ?? {}).length;
  const all = lists.reduce((sum, { objects }) => sum + objects.length, 0);
  const aliens = file.aliens?.length ?? 0;
  const places = [
    file.astronaut,
    file.blackHole,
    ...lists.flatMap(({ kind, objects }) => objects.flatMap((object) => placesOf({ kind, object }))),
  ];
  const isFar = places.some(({ x, y }) => Math.max(Math.abs(x), Math.abs(y)) > FAR);
  const counts = [
    ...lists
      .filter(({ objects }) => objects.length > 0)
      .map(({ kind, objects }) => count(objects.length, [KINDS[kind].one, KINDS[kind].many])),
    ...(rules === 0 ? [] : [count(rules, ['changed rule', 'changed rules'])]),
    runs.length === 0 ? 'no run' : `${count(runs.length, ['run', 'runs'])} with ${count(holds, ['hold', 'holds'])}`,
  ];
  const warnings = [
    ...(all > MANY.objects || aliens > MANY.aliens ? ['It has very many objects: the page may be slow while it is open.'] : []),
    ...(runs.length > MANY.runs || holds > MANY.holds
      ? ['It has very many runs or holds: the page may be slow while it is open.']
      : []),
    ...(isFar ? [`Some objects are more than ${FAR.toLocaleString('en')} px from the origin.`] : []),
  ];
  const kB = new TextEncoder().encode(text).length / 1000;
  return { counts: counts.join(', '), size: `${kB < 10 ? kB.toFixed(1) : Math.round(kB).toLocaleString('en')} kB`, warnings };
}
