import { type Advice, type CheckCode, explainCodes } from '../../../check/words/index.ts';
import { WARNING_CODES } from '../../../engine/index.ts';
import { CODES, type CodeExplanation } from '../../../schema/index.ts';

/** What the page can tell of a level: it looks for no run unless it is asked to, and for slack elsewhere. */
type PageCode = Exclude<
  CheckCode,
  'found-run' | 'no-run-found' | 'low-slack' | 'slack-below-required' | 'unreadable-file' | 'crashed'
>;

/** What to do on the page about the problems that only checking a level can show. */
const ADVICE: Readonly<Record<PageCode, Advice>> = {
  'no-run': { fix: 'Play it and make an attempt the proof, let the solver find a run, or draw one in the gun lane.' },
  'run-does-not-complete': { fix: 'Move what is in the way, change the holds in the gun lane, or take the run out.' },
  'verdict-hangs-on-accuracy': {
    fix: 'See the near misses on the way and give her more room there. The accuracy panel has what each setting makes of it.',
  },
  'proved-impossible': { fix: 'Move what the reason names. Solve draws the proof on the canvas.' },
  'mineral-never-collectable': { fix: 'Move the mineral, or what keeps her from it.' },
  'work-limit': {
    also: 'While a level is edited the page plays less of it; a worker plays the rest.',
    fix: 'The message says what ran out. Take out what the level does not need, aliens above all, or the runs that prove nothing.',
  },
};

/** What only a page knows that has the level open. */
const OF_THE_FILE: readonly CodeExplanation[] = [
  {
    code: 'file-unreadable',
    severity: 'error',
    title: 'the file on the disk is no valid level now',
    why: 'Another program has written something into the file that can not be read as a level. `gq check` would call it invalid. The page keeps the last good state and writes nothing over the file.',
    fix: 'Mend the file where the place says: once it can be read, the page goes on by itself. Or write what is on the screen over it.',
  },
  {
    code: 'file-deleted',
    severity: 'error',
    title: 'the file was deleted or moved on the disk',
    why: 'The level is on the screen and kept in this browser, and has no file.',
    fix: 'Write it again, save it as a new level, or let it go.',
  },
];

const OF_THE_CHECK = explainCodes(ADVICE, { longestRun: 'a minute', mostWork: 'the limit of `gq check`' });

const ALL = new Map(
  [...CODES, ...WARNING_CODES, ...OF_THE_CHECK, ...OF_THE_FILE].map((explanation) => [explanation.code, explanation]),
);

/** What a code means; null for one that is not known. */
export const explanationOf = (code: string): CodeExplanation | null => ALL.get(code) ?? null;
