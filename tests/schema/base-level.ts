/** A valid level with an object of every kind; tests break it in one place. */
export const BASE = `{
  "version": 1,
  "name": "Base",
  "astronaut": { "x": 712, "y": 600 },
  "blackHole": { "x": 708, "y": 826, "radius": 18 },
  "range": 250,
  "asteroids": [
    { "id": "k3x9qa", "x": 708, "y": 680, "radius": 16 },
    { "id": "m2p8zz", "x": 640.25, "y": -1.5e-7, "radius": 32, "hot": true }
  ],
  "novae": [
    { "id": "aa11", "x": 1, "y": 2, "radius": 16 }
  ],
  "minerals": [
    { "x": 715, "y": 730 }
  ],
  "runs": [
    {
      "name": "first",
      "holds": [
        [12, 96],
        [130, 188]
      ]
    }
  ]
}
`;

/** `BASE` with one part replaced. */
export function broken(part: string, by: string): string {
  if (BASE.split(part).length !== 2) throw new Error(`${part} must stand exactly once in the base level`);
  return BASE.replace(part, () => by);
}
