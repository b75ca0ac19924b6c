import { type Advice, type CheckCode, explainCodes } from '../../check/words/index.ts';

/** What to do on the command line about the problems that only checking a level can show. */
const ADVICE: Readonly<Record<CheckCode, Advice>> = {
  'run-does-not-complete': {
    fix:
      'Look at what happens with `gq simulate LEVEL --run NAME` or `gq render LEVEL --run NAME -o run.svg`, then move what is in ' +
      'the way, change the holds, or take the run out.',
  },
  'no-run': {
    fix:
      'Let one be found with `gq solve LEVEL --write`, or add one: a name, and the ticks (1/60 s) in which the gun is held, ' +
      '[press, release). `gq check --solve` searches without writing.',
    example: '"runs": [\n  { "name": "solution", "holds": [[12, 96], [130, 188]] }\n]',
  },
  'found-run': {
    fix: 'Keep it: `gq solve LEVEL --write` finds a run, the one that forgives most, and puts it into the file.',
  },
  'no-run-found': {
    fix:
      'Draw the nearest with `gq render LEVEL --holds ... -o near.svg`, or where the search has been with `gq render LEVEL ' +
      '--explored -o explored.svg`. Make the level easier, or search longer with `gq solve LEVEL --budget 60`.',
  },
  'proved-impossible': {
    fix:
      'The message says what to move. `gq render LEVEL --proof -o proof.svg` draws it, `gq solve LEVEL --format json` has the ' +
      'certificate.',
  },
  'mineral-never-collectable': {
    also: 'It takes up to a tenth of a second a level, so of more than 64 files at once it is looked for with --solve only.',
    fix: 'Move the mineral, or what keeps her from it, as the message says.',
  },
  'low-slack': {
    fix:
      'Give her more room where `gq difficulty LEVEL` shows the smallest window, or take a run that forgives more: `gq solve LEVEL` ' +
      'looks for the one that forgives most.',
  },
  'slack-below-required': {
    fix:
      'Give her more room where `gq difficulty LEVEL` shows the smallest window, replace the run by one that forgives more (`gq solve ' +
      'LEVEL`), or ask for less.',
  },
  'verdict-hangs-on-accuracy': {
    fix:
      'Look at what each accuracy makes of it with `gq accuracy LEVEL --run NAME`, and at where it is close with `gq simulate LEVEL ' +
      '--run NAME` (its clearance). Give her more room there, or find a run that keeps away. If the level is only ever played at ' +
      'one accuracy, check it with that one.',
  },
  'work-limit': {
    fix:
      'The message says what ran out, and where. Take out what the level does not need, or the runs that prove nothing; or allow more ' +
      'with `gq check --max-work N` where you know the level. The default lets the check of any file end within seconds.',
  },
  'unreadable-file': {
    fix: 'Make the file readable, or leave it out of the paths that are checked.',
  },
  crashed: {
    fix: 'Please report it with the level file and the message.',
  },
};

/** The problems that only checking a level can show, explained. */
export const CHECK_CODES = explainCodes(ADVICE, { longestRun: '--max-time', mostWork: '--max-work' });
