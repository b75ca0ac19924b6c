import { DEFAULT_RADIUS, DEFAULT_RANGE, type Level, type LevelFile } from './level.ts';

type Placed = { id?: string | undefined; x: number; y: number; radius?: number | undefined };

// + 0 turns -0 into 0: it is written as 0, and must not be another start than 0
const circle = (o: Placed, radius: number) => ({ id: o.id ?? null, x: o.x + 0, y: o.y + 0, radius: o.radius ?? radius });

/** Fills in every default that the file leaves out. Pure; `file` is not changed. */
export function resolveLevel(file: LevelFile): Level {
  const { astronaut } = file;
  return {
    name: file.name,
    description: file.description ?? '',
    astronaut: { x: astronaut.x + 0, y: astronaut.y + 0, vx: (astronaut.vx ?? 0) + 0, vy: (astronaut.vy ?? 0) + 0 },
    blackHole: { x: file.blackHole.x + 0, y: file.blackHole.y + 0, radius: file.blackHole.radius ?? DEFAULT_RADIUS.blackHole },
    range: file.range ?? DEFAULT_RANGE,
    recoil: file.recoil ?? false,
    asteroids: (file.asteroids ?? []).map((o) => ({ ...circle(o, o.radius), hot: o.hot ?? false })),
    novae: (file.novae ?? []).map((o) => circle(o, o.radius)),
    repulsors: (file.repulsors ?? []).map((o) => circle(o, o.radius)),
    aliens: (file.aliens ?? []).map((o) => circle(o, DEFAULT_RADIUS.alien)),
    minerals: (file.minerals ?? []).map((o) => circle(o, DEFAULT_RADIUS.mineral)),
    runs: (file.runs ?? []).map((run) => ({
      name: run.name,
      holds: run.holds.map(([press, release]) => [press + 0, release] as const),
    })),
  };
}
