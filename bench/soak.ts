import { shrinkMixed } from '../tests/judges/check-mixed.ts';
import { atLeast, atMost, define, number, oneOf } from './harness/index.ts';
import { attackProofs, PROOF_OPTIONS } from './soak/attack-proofs.ts';
import { attackProperties, attackSignals, attackWriters } from './soak/commands.ts';
import { attackScenes, SCENES, type SceneAttack } from './soak/scenes.ts';
import { attackBySteps, attackContacts, attackCost } from './soak/seeds.ts';
import type { Attacked, Span } from './soak/span.ts';

const ATTACKS = [
  ...(Object.keys(SCENES) as SceneAttack[]),
  ...(['small-steps', 'contacts', 'cost', 'properties', 'proofs', 'signals', 'writers'] as const),
];
type Attack = (typeof ATTACKS)[number];

const OTHERS: Readonly<Partial<Record<Attack, (span: Span) => Attacked | Promise<Attacked>>>> = {
  'small-steps': attackBySteps,
  contacts: attackContacts,
  cost: attackCost,
  properties: attackProperties,
  signals: attackSignals,
  writers: attackWriters,
};

const isOfScenes = (attack: Attack): attack is SceneAttack => Object.hasOwn(SCENES, attack);

/** Shows one scene, what is found in it, and a smaller one with the same fault. Returns the number of bugs. */
function show(attack: SceneAttack, seed: number): number {
  const { scene, find } = SCENES[attack];
  const findings = find(seed);
  console.log(JSON.stringify(scene(seed)));
  console.log(JSON.stringify(findings, null, 2));
  const bugs = findings.filter(({ kind }) => kind === 'bug');
  if ((attack === 'mixed' || attack === 'starts') && bugs.length > 0) {
    console.log(`smaller: ${JSON.stringify(shrinkMixed(scene(seed), seed, bugs[0]))}`);
  }
  return bugs.length;
}

export const bench = define({
  what: 'attacks, one after the other; hours',
  options: {
    attack: oneOf(ATTACKS, null, 'only one'),
    from: number(0, 'the first seed'),
    scenes: number(100_000, 'seeds of each attack'),
    seconds: number(900, 'for each attack'),
    only: number(null, 'shows one scene, and what is found in it'),
    ...PROOF_OPTIONS,
  },
  claims: { bugs: atMost(0, 'bugs'), tried: atLeast(1, 'tried') },
  async run({ attack: named, from, scenes: most, seconds, only, ...ofProofs }) {
    const bugs: Record<string, number> = {};
    const tried: Record<string, number> = {};
    const rows: (string | number)[][] = [];
    const note = (attack: Attack, found: Attacked): void => {
      bugs[attack] = found.bugs;
      tried[attack] = found.tried;
      rows.push([attack, found.tried, found.bugs, found.told]);
    };
    if (only !== null) {
      const attack = named !== null && isOfScenes(named) ? named : 'rules';
      note(attack, { tried: 1, bugs: show(attack, only), told: `scene ${only}` });
    } else {
      for (const attack of named === null ? ATTACKS : [named]) {
        console.log(`\n== ${attack}`);
        const span = { from, most, until: Date.now() + 1000 * seconds };
        if (isOfScenes(attack)) note(attack, await attackScenes(attack, span));
        else note(attack, (await OTHERS[attack]?.(span)) ?? attackProofs(ofProofs, from, seconds));
      }
    }
    return {
      title: 'Attacks',
      columns: ['attack', 'tried', 'bugs', ''],
      rows,
      measured: { bugs, tried },
      notes: [],
    };
  },
});
