import type { Problem } from '../../schema/index.ts';
import { OUTDONE_WARNINGS, type Proof } from '../../solver/index.ts';

/** What a worker has proved of a level. */
export interface Proved {
  readonly impossible: Proof | null;
  readonly minerals: readonly { readonly index: number; readonly proof: Proof }[];
  /** Why what is left was not looked for to the end; null: it was, or is going on. */
  readonly gaveUp?: string | null;
}

const hintOf = ({ code }: Proof): string =>
  `proved (${code}), and the proof confirmed by a separate checker: move what the reason names`;

/**
 * Proofs as problems, with the codes of `gq check`.
 * @param known the problems without proofs; what is proved is no longer guessed
 */
export function withProofs(known: readonly Problem[], { impossible, minerals, gaveUp = null }: Proved): Problem[] {
  const proved: Problem[] = [];
  const add = (code: string, severity: Problem['severity'], message: string, proof: Proof, pointer: string) =>
    proved.push({ code, severity, message, hint: hintOf(proof), pointer, line: null, column: null });
  if (impossible !== null) {
    const pointer = impossible.code === 'out-of-range' ? '/blackHole' : '/astronaut';
    add('proved-impossible', 'error', `nobody can complete this level: ${impossible.reason}`, impossible, pointer);
  }
  for (const { index, proof } of minerals) {
    add(
      'mineral-never-collectable',
      'warning',
      `nobody can collect mineral ${index + 1}: ${proof.reason}`,
      proof,
      `/minerals/${index}`,
    );
  }
  const places = new Set(minerals.map(({ index }) => `/minerals/${index}`));
  const outdone = impossible === null ? [] : ['no-run', OUTDONE_WARNINGS[impossible.code]];
  const isGuess = ({ code, pointer }: Problem) =>
    outdone.includes(code) || (code === 'mineral-out-of-reach' && places.has(pointer));
  if (gaveUp !== null && impossible === null) {
    proved.push({
      code: 'work-limit',
      severity: 'warning',
      message: `${gaveUp}: whether something here is out of reach was not proved`,
      hint: 'gq check may look for longer; fewer objects make it quicker',
      pointer: '',
      line: null,
      column: null,
    });
  }
  return [...proved, ...known.filter((problem) => !isGuess(problem))];
}
