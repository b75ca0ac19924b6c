import { DEFAULT_MAX_WORK, unlimited } from '../engine/index.ts';
import { type Level, resolveLevel } from '../schema/index.ts';
import { type Proof, proveImpossible, verifyProof } from '../solver/index.ts';
import { RANDOM_SET_SIZE, randomLevel } from '../tests/scenes/random-set/index.ts';
import { askedLevels, atMost, define, LEVELS, median, number, processorTime } from './harness/index.ts';

/** A hundredth of what `gq check` allows a level, pieces of motion. */
const MOST_WORK = DEFAULT_MAX_WORK / 100;

type Edit = readonly [name: string, edit: (level: Level) => Level];

/** Circles around the black hole, so close to each other that her box does not fit between them. */
function wall({ blackHole: { x, y, radius } }: Level): Level['novae'] {
  const r = radius + 50;
  const count = Math.ceil((2 * Math.PI * r) / 28);
  return Array.from({ length: count }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    return { id: null, x: x + r * Math.cos(turn), y: y + r * Math.sin(turn), radius: 16 };
  });
}

/** Edits by which a designer may put the black hole out of reach. */
const EDITS: readonly Edit[] = [
  ['the black hole moved far away', (level) => ({ ...level, blackHole: { ...level.blackHole, x: level.blackHole.x + 20_000 } })],
  ['the asteroids taken away', (level) => ({ ...level, asteroids: [] })],
  ['novae all around the black hole', (level) => ({ ...level, novae: [...level.novae, ...wall(level)] })],
];

interface Row {
  readonly kind: string;
  readonly proof: Proof | null;
  readonly prove: number;
  /** What it cost, pieces of motion. */
  readonly work: number;
  readonly verify: number;
}

function prove(kind: string, level: Level): Row {
  let proof: Proof | null = null;
  const budget = unlimited();
  const time = processorTime(() => {
    proof = proveImpossible(level, { budget });
  });
  const found = proof as Proof | null;
  const verify = processorTime(() => {
    if (found === null) return;
    const verdict = verifyProof(level, found);
    if (!verdict.ok) throw new Error(`expected a proof that its checker accepts, found ${found.code}: ${verdict.why}`);
  });
  return { kind, proof: found, prove: time, work: budget.spent, verify };
}

export const bench = define({
  what: 'time to prove edited levels impossible, and which levels of the random set are proved',
  options: { ...LEVELS, random: number(RANDOM_SET_SIZE, 'levels of the random set') },
  claims: {
    unproved: atMost(0, 'edited levels that are not proved impossible'),
    work: atMost(MOST_WORK, 'work to prove an edited level impossible, worst'),
  },
  run({ random: count, ...asked }) {
    const levels = askedLevels(asked).map(({ level }) => level);
    for (const level of levels) prove('warm-up', level);
    const edited = EDITS.flatMap(([name, edit]) => levels.map((level) => prove(name, edit(level))));
    const random = Array.from({ length: count }, (_, seed) => {
      const row = prove('', resolveLevel(randomLevel(seed)));
      return { ...row, kind: `random set: ${row.proof?.code ?? 'no proof'}` };
    });
    const tried = [...edited, ...random];
    const rows = [...new Set(tried.map(({ kind }) => kind))].map((kind) => {
      const all = tried.filter((row) => row.kind === kind);
      const proofs = all.flatMap(({ proof }) => proof ?? []);
      const sizes = proofs.map(({ certificate }) => JSON.stringify(certificate).length);
      const most = (of: (row: Row) => number) => Math.max(...all.map(of));
      return [
        kind,
        all.length,
        proofs.length,
        proofs.filter(({ covers }) => covers.includes('arcade')).length,
        median(all.map(({ prove: ms }) => ms)),
        most(({ prove: ms }) => ms),
        most(({ work }) => work),
        most(({ verify }) => verify),
        sizes.length > 0 ? Math.max(...sizes) : null,
      ];
    });
    return {
      title: `Proofs of impossibility: ${levels.length} levels edited, ${random.length} random levels`,
      columns: [
        ...['levels', 'count', 'proved', 'for arcade too', 'ms, median', 'ms, worst', 'work, worst', 'to check, ms'],
        'certificate, bytes',
      ],
      rows,
      measured: {
        unproved: edited.filter(({ proof }) => proof === null).length,
        work: Math.max(...edited.map(({ work }) => work)),
      },
      notes: [
        'Every proof was checked by the separate checker. Times are of the processor; the work is in pieces of motion, of which `gq check` allows 400,000 a level.',
      ],
    };
  },
});
