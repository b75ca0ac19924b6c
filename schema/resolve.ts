import { DEFAULT_RADIUS, DEFAULT_RANGE, type Level, type LevelFile } from './level.ts';

type Placed = { id?: string | undefined; x: number; y: number; radius?: number | undefined };

const circle = (o: Placed, radius: number) => ({ id: o.id ?? null, x: o.x, y: o.y, radius: o.radius ?? radius });

/** Fills in every default that the file leaves out. Pure; `file` is not changed. */
export function resolveLevel(file: LevelFile): Level {
  return {
    name: file.name,
    description: file.description ?? '',
    astronaut: { x: file.astronaut.x, y: file.astronaut.y, vx: file.astronaut.vx ?? 0, vy: file.astronaut.vy ?? 0 },
    blackHole: { x: file.blackHole.x, y: file.blackHole.y, radius: file.blackHole.radius ?? DEFAULT_RADIUS.blackHole },
    range: file.range ?? DEFAULT_RANGE,
    recoil: file.recoil ?? false,
    asteroids: (file.asteroids ?? []).map((o) => ({ ...circle(o, o.radius), hot: o.hot ?? false })),
    novae: (file.novae ?? []).map((o) => circle(o, o.radius)),
    repulsors: (file.repulsors ?? []).map((o) => circle(o, o.radius)),
    aliens: (file.aliens ?? []).map((o) => circle(o, DEFAULT_RADIUS.alien)),
    minerals: (file.minerals ?? []).map((o) => circle(o, DEFAULT_RADIUS.mineral)),
    runs: file.runs ?? [],
  };
}
