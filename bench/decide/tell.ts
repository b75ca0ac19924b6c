import type { Level } from '../../schema/index.ts';
import type { NamedLevel } from '../harness/index.ts';
import { type Decision, FEW_SQUARES } from './decide.ts';

/** A kind of level for which the share of decided levels is reported; a level can be in several. */
export type Stratum = readonly [name: string, has: (level: NamedLevel) => boolean];

/** Says how many levels are decided, by stratum, and describes each undecided level. */
export function tell(levels: readonly NamedLevel[], decisions: readonly Decision[], strata: readonly Stratum[]) {
  const byName = new Map(levels.map((level) => [level.name, level]));
  const levelOf = ({ name }: Decision): NamedLevel => byName.get(name) as NamedLevel;
  const count = (of: readonly Decision[], verdict: Decision['verdict']) => of.filter((d) => d.verdict === verdict).length;
  const rows = strata.map(([name, has]) => {
    const here = decisions.filter((decision) => has(levelOf(decision)));
    const undecided = count(here, 'undecided');
    const share = here.length === 0 ? null : `${((100 * (here.length - undecided)) / here.length).toFixed(2)} %`;
    return [name, here.length, count(here, 'completable'), count(here, 'impossible'), undecided, share];
  });
  const proofs = new Map<string, number>();
  for (const { verdict, proof } of decisions) {
    if (verdict === 'impossible' && proof !== null) proofs.set(proof, (proofs.get(proof) ?? 0) + 1);
  }
  const undecided = decisions.filter(({ verdict }) => verdict === 'undecided');
  const wrong = decisions.filter(({ proof }) => proof === 'REFUTED' || proof?.startsWith('unverified'));
  const searched = decisions.filter(({ verdict }) => verdict === 'completable').map(({ ticks }) => ticks);
  searched.sort((a, b) => a - b);
  const refuted = decisions.filter(({ verdict, refutingTicks }) => verdict === 'impossible' && refutingTicks > 0);
  const most = (of: (decision: Decision) => number) => Math.round(Math.max(0, ...decisions.map(of)));
  return {
    columns: ['levels', 'number', 'completable', 'impossible', 'undecided', 'decided'],
    rows,
    /** The share of the levels that nothing decides, and the number of proofs that do not hold. */
    undecided: undecided.length / Math.max(1, decisions.length),
    wrong: wrong.length,
    notes: [
      `Proofs: ${[...proofs].map(([code, n]) => `${code} ${n}`).join(', ') || 'none'}.`,
      `Ticks to the first run: median ${searched[searched.length >> 1] ?? '-'}, most ${searched.at(-1) ?? '-'}.`,
      `Processor time of a level at most: quick proofs ${most((d) => d.proofMs)} ms, search and longer proofs ${most((d) => d.searchMs)} ms, checker ${most((d) => d.verifyMs)} ms.`,
      ...(refuted.length > 0
        ? [
            `Searched against a proof: ${refuted.length} levels, ${refuted.reduce((sum, { refutingTicks }) => sum + refutingTicks, 0)} ticks.`,
          ]
        : []),
      ...(undecided.length > 0 ? [`Undecided: ${inCommon(undecided, (d) => levelOf(d).level)}.`] : []),
      ...undecided.map((d) => `undecided ${d.name}: ${aboutLevel(d, levelOf(d).level)}`),
      ...wrong.map(({ name, proof }) => `WRONG ${name}: ${proof}`),
    ],
  };
}

const isMoving = ({ astronaut }: Level): boolean => astronaut.vx !== 0 || astronaut.vy !== 0;

/** What undecided levels have in common: how she starts, whether asteroids move, and how far she gets. */
function inCommon(undecided: readonly Decision[], levelOf: (decision: Decision) => Level): string {
  const kinds = new Map<string, number>();
  for (const decision of undecided) {
    const level = levelOf(decision);
    const start = isMoving(level) ? 'moving' : 'at rest';
    const kind = `${start}${level.recoil ? ', recoil' : ''}, ${decision.squares <= FEW_SQUARES ? 'soon over' : 'roams'}`;
    kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
  }
  return [...kinds]
    .sort(([, a], [, b]) => b - a)
    .map(([kind, n]) => `${kind} ${n}`)
    .join('; ');
}

/** Facts that may explain why a level is undecided. */
function aboutLevel({ closest, squares, ticks }: Decision, level: Level): string {
  const parts = [
    `${level.asteroids.length} asteroids`,
    `${level.novae.length} novae`,
    `${level.aliens.length} aliens`,
    `${level.repulsors.length} repulsors`,
    ...(level.recoil ? ['recoil'] : []),
    ...(isMoving(level) ? ['moving'] : []),
    `${squares} squares`,
    `closest ${closest === null ? '-' : closest.toFixed(1)} px in ${ticks} ticks`,
  ];
  return parts.join(', ');
}
