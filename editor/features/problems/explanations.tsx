import { type Advice, type CheckCode, explainCodes } from '../../../check/words/index.ts';
import { WARNING_CODES } from '../../../engine/index.ts';
import { CODES, type CodeExplanation } from '../../../schema/index.ts';

/** The codes that the page can report: it does not search for runs unless asked, and shows slack elsewhere. */
type PageCode = Exclude<
  CheckCode,
  | 'found-run'
  | 'no-run-found'
  | 'softlock'
  | 'low-slack'
  | 'slack-below-required'
  | 'result-changed'
  | 'not-in-lock'
  | 'pack-missing-level'
  | 'pack-repeated-level'
  | 'pack-unlisted-level'
  | 'pack-introduction'
  | 'pack-empty-chapter'
  | 'unreadable-file'
  | 'crashed'
>;

/** What to do on the page about the problems that only a check of the level finds. */
const ADVICE: Readonly<Record<PageCode, Advice>> = {
  'no-run': { fix: 'Play the level and keep an attempt as a run, let the solver find a run, or draw one in the gun lane.' },
  'run-does-not-complete': { fix: 'Move what is in the way, change the holds in the gun lane, or delete the run.' },
  'verdict-hangs-on-accuracy': {
    fix: 'Look for near misses along the path and give her more room there. The accuracy panel shows the result at each setting.',
  },
  'proved-impossible': { fix: 'Move the objects that the reason names. Solve draws the proof on the canvas.' },
  'mineral-never-collectable': { fix: 'Move the mineral, or the objects that keep her from it.' },
  'unused-allow': { fix: 'Remove the code from "allow" in the level file.' },
  'work-limit': {
    also: 'While a level is edited, the page simulates less of it; a worker simulates the rest.',
    fix: 'The message says which limit was reached. Delete what the level does not need: aliens above all, or runs that do not complete it.',
  },
};

/** Codes that only an open page reports. */
const OF_THE_FILE: readonly CodeExplanation[] = [
  {
    code: 'file-unreadable',
    severity: 'error',
    title: 'the file on disk is no longer a valid level',
    why: 'Another program has changed the file, and it can no longer be read as a level. `gq check` would call it invalid. The page keeps the last valid state and does not overwrite the file.',
    fix: 'Fix the file at the given place: the page continues by itself once the file is valid. Or overwrite it with the level on the screen.',
  },
  {
    code: 'file-deleted',
    severity: 'error',
    title: 'the file was deleted or moved on disk',
    why: 'The level is on the screen and kept in this browser, but has no file.',
    fix: 'Save it again, save it as a new level, or close it.',
  },
];

const OF_THE_CHECK = explainCodes(ADVICE, { longestRun: 'a minute', mostWork: 'the limit of `gq check`' });

const ALL = new Map(
  [...CODES, ...WARNING_CODES, ...OF_THE_CHECK, ...OF_THE_FILE].map((explanation) => [explanation.code, explanation]),
);

/** The explanation of a code; null if the code is unknown. */
export const explanationOf = (code: string): CodeExplanation | null => ALL.get(code) ?? null;

/** Why a problem matters and how to fix it. */
export function Explanation({ code }: { readonly code: string }) {
  const explanation = explanationOf(code);
  if (explanation === null) return <p>Not explained here. Try gq explain {code}.</p>;
  return (
    <>
      <p>
        <b>{explanation.title}.</b> {explanation.why}
      </p>
      <p>{explanation.fix}</p>
    </>
  );
}
