import { type Disc, type Hold, LEVEL_VERSION, type Level, type LevelFile, resolveLevel, withIds } from '../../schema/index.ts';
import type { Layout } from './layout.ts';

const circle = ({ x, y, radius }: Disc) => ({ x, y, radius });
const place = ({ x, y }: Disc) => ({ x, y });

/** The format's default, px. */
const USUAL_BLACK_HOLE = 18;

/** Converts a layout into a level file. Empty lists are left out, and so are radii that are the format's defaults. */
export function toLevelFile(
  layout: Layout,
  name: string,
  description: string,
  runs: readonly { readonly name: string; readonly holds: readonly Hold[] }[],
): LevelFile {
  const { start, blackHole, recoil, rules, asteroids, novae, repulsors, aliens, minerals, placed } = layout;
  return withIds({
    version: LEVEL_VERSION,
    name,
    description,
    astronaut: { x: start.x, y: start.y, ...((start.vx !== 0 || start.vy !== 0) && { vx: start.vx, vy: start.vy }) },
    blackHole: { ...place(blackHole), ...(blackHole.radius !== USUAL_BLACK_HOLE && { radius: blackHole.radius }) },
    ...(recoil && { recoil }),
    ...(Object.keys(rules).length > 0 && { rules }),
    asteroids: asteroids.map(({ hot, ...rest }) => ({ ...circle(rest), ...(hot && { hot }) })),
    ...(novae.length > 0 && { novae: novae.map(circle) }),
    ...(repulsors.length > 0 && { repulsors: repulsors.map(circle) }),
    ...(aliens.length > 0 && { aliens: aliens.map(place) }),
    ...(minerals.length > 0 && { minerals: minerals.map(place) }),
    ...Object.fromEntries(Object.entries(placed).filter(([, objects]) => objects.length > 0)),
    runs: runs.map((run) => ({
      name: run.name,
      holds: run.holds.map(([press, release]) => [press, release] as [number, number]),
    })),
  });
}

/** Converts a layout into a level to simulate. */
export const toLevel = (layout: Layout): Level => resolveLevel(toLevelFile(layout, 'generated', '', []));
