/** She falls from rest through a cold asteroid into the black hole behind it while the gun is held; some objects are beside. */
export const straight = (changes: Readonly<Record<string, unknown>> = {}): Record<string, unknown> => ({
  version: 1,
  name: 'Straight',
  astronaut: { x: 200, y: 304 },
  blackHole: { x: 704, y: 304 },
  asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16 }],
  novae: [{ id: 'nova', x: 448, y: 520, radius: 32 }],
  minerals: [{ id: 'gem', x: 320, y: 304, radius: 7 }],
  runs: [{ name: 'solution', holds: [[0, 600]] }],
  ...changes,
});

/** She drifts into the black hole within three seconds, whatever the gun does. */
export const near = (changes: Readonly<Record<string, unknown>> = {}): Record<string, unknown> =>
  straight({ astronaut: { x: 200, y: 304, vx: 60 }, blackHole: { x: 400, y: 304 }, ...changes });

/** One of each kind and three asteroids, all on the grid of 8 px and far from one another. */
export const garden = (changes: Readonly<Record<string, unknown>> = {}): Record<string, unknown> => ({
  version: 1,
  name: 'Garden',
  astronaut: { x: 200, y: 304 },
  blackHole: { x: 904, y: 304 },
  asteroids: [
    { id: 'a1', x: 400, y: 200, radius: 32 },
    { id: 'b1', x: 560, y: 160, radius: 32 },
    { id: 'c1', x: 720, y: 240, radius: 16 },
  ],
  novae: [{ id: 'n1', x: 400, y: 440, radius: 32 }],
  repulsors: [{ id: 'r1', x: 200, y: 480, radius: 48 }],
  aliens: [{ id: 'e1', x: 720, y: 440 }],
  minerals: [{ id: 'm1', x: 560, y: 480 }],
  runs: [{ name: 'solution', holds: [[30, 90]] }],
  ...changes,
});
