import {
  type Disc,
  fieldsOf,
  type Hold,
  LEVEL_VERSION,
  type Level,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  type ObjectList,
  resolveLevel,
  withIds,
} from '../../../schema/index.ts';
import type { Layout } from './layout.ts';

const circle = ({ x, y, radius }: Disc) => ({ x, y, radius });
const place = ({ x, y }: Disc) => ({ x, y });

/** The format's default, px. */
const USUAL_BLACK_HOLE = 18;

/** The lists that have objects, in the order of a file. */
const listsOf = (lists: Partial<Record<ObjectList, readonly Disc[]>>) =>
  Object.fromEntries(
    LISTED_KINDS.flatMap((kind) => {
      const objects = lists[listOf(kind)] ?? [];
      const usual = fieldsOf(kind).find(([name]) => name === 'radius')?.[1].default;
      const inFile = objects.map((one) =>
        Object.fromEntries(Object.entries(one).filter(([name, value]) => name !== 'radius' || value !== usual)),
      );
      return objects.length === 0 ? [] : [[listOf(kind), inFile]];
    }),
  );

/** Converts a layout into a level file. Empty lists are left out, and so are radii that are the format's defaults. */
export function toLevelFile(
  layout: Layout,
  name: string,
  description: string,
  runs: readonly { readonly name: string; readonly holds: readonly Hold[] }[],
): LevelFile {
  const { start, blackHole, recoil, rules, asteroids, novae, minerals, placed } = layout;
  return withIds({
    version: LEVEL_VERSION,
    name,
    description,
    astronaut: { x: start.x, y: start.y, ...((start.vx !== 0 || start.vy !== 0) && { vx: start.vx, vy: start.vy }) },
    blackHole: { ...place(blackHole), ...(blackHole.radius !== USUAL_BLACK_HOLE && { radius: blackHole.radius }) },
    ...(recoil && { recoil }),
    ...(Object.keys(rules).length > 0 && { rules }),
    asteroids: asteroids.map(({ hot, ...rest }) => ({ ...circle(rest), ...(hot && { hot }) })),
    ...listsOf({ novae, minerals, ...placed }),
    runs: runs.map((run) => ({
      name: run.name,
      holds: run.holds.map(([press, release]) => [press, release] as [number, number]),
    })),
  });
}

/** Converts a layout into a level to simulate. */
export const toLevel = (layout: Layout): Level => resolveLevel(toLevelFile(layout, 'generated', '', []));
