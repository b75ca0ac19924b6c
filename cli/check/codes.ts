import { type Advice, type CheckCode, explainCodes } from '../../check/words/index.ts';

/** Hints for the command line about problems that only a check can find. */
const ADVICE: Readonly<Record<CheckCode, Advice>> = {
  'run-does-not-complete': {
    fix:
      'See how the run ends with `gq simulate LEVEL --run NAME` or `gq render LEVEL --run NAME -o run.svg`. Then move what is in ' +
      'the way, change the holds, or delete the run.',
  },
  'no-run': {
    fix:
      'Find one with `gq solve LEVEL --write`, or add one: a name, and the ticks (1/60 s) in which the gun is held, as ' +
      '[press, release). `gq check --solve` searches without writing.',
    example: '"runs": [\n  { "name": "solution", "holds": [[12, 96], [130, 188]] }\n]',
  },
  'found-run': {
    fix: 'Keep such a run: `gq solve LEVEL --write` finds the one that forgives most and adds it to the file.',
  },
  'no-run-found': {
    fix:
      'Draw the run of the closest approach with `gq render LEVEL --holds ... -o near.svg`, or where the search has been with `gq render ' +
      'LEVEL --explored -o explored.svg`. Make the level easier, or search longer with `gq solve LEVEL --budget 60`.',
  },
  'proved-impossible': {
    fix:
      'The message says what to move. `gq render LEVEL --proof -o proof.svg` draws it, `gq solve LEVEL --format json` has the ' +
      'certificate.',
  },
  'mineral-never-collectable': {
    also: 'The proof takes up to a tenth of a second for each level. So when more than 64 files are checked, it is attempted only with --solve.',
    fix: 'Move the mineral, or what keeps her from it, as the message says.',
  },
  softlock: {
    fix:
      'End the run sooner there, with a hazard or a smaller range, or give her a way back, such as another asteroid. `gq render LEVEL ' +
      '--softlocks -o lost.svg` draws the places.',
  },
  'low-slack': {
    fix:
      'Give her more room where `gq difficulty LEVEL --run NAME` shows the smallest window, or use a run that forgives more: `gq solve LEVEL` ' +
      'looks for the one that forgives most.',
  },
  'slack-below-required': {
    fix:
      'Give her more room where `gq difficulty LEVEL --run NAME` shows the smallest window, replace the run with one that forgives more (`gq solve ' +
      'LEVEL`), or require less.',
  },
  'verdict-hangs-on-accuracy': {
    fix:
      'Compare the accuracies with `gq accuracy LEVEL --run NAME`, and see where she passes a hazard closely with `gq simulate LEVEL ' +
      '--run NAME` (its clearance). Give her more room there, or find a run that keeps its distance. If the level is only ever played ' +
      'at one accuracy, check it with that one.',
  },
  'work-limit': {
    fix:
      'The message says what was exceeded and where. Delete what the level does not need, or runs that show nothing. If you know the ' +
      'level, you can allow more with `gq check --max-work N`. With the default, the check of any file ends within seconds.',
  },
  'result-changed': {
    fix:
      'If the change is wanted, agree anew with `gq check --update-lock` and have the change of the lock reviewed with that of the level. ' +
      'If not, `git diff` of the level and of gq.config.json shows where it comes from.',
  },
  'not-in-lock': {
    fix: 'Agree on its result with `gq check --update-lock`, and commit the lock with the level.',
  },
  'unused-allow': {
    also: 'What the check was not asked to look for, such as slack without --solve and --require-slack, is never called unused.',
    fix: 'Remove the code from "allow" in the level.',
    example: '"allow": { "unused-asteroid": "a landmark" }',
  },
  'pack-missing-level': {
    fix: 'Correct the id in pack.json, or remove the entry. An id is the path of the file below the folder, without .level.json.',
    example: '"levels/07-slingshot.level.json"  ->  "07-slingshot"',
  },
  'pack-repeated-level': {
    fix: 'Remove one of the two entries from pack.json.',
  },
  'pack-unlisted-level': {
    fix: 'List it in pack.json where it belongs. Leave drafts out of the check with "ignore" in gq.config.json.',
  },
  'pack-introduction': {
    fix: 'Put a level before it that has only one of the new effects, or move the level. If they belong together, say so in pack.json.',
    example: '"18-storm"  ->  { "level": "18-storm", "introduces": ["novae", "recoil"] }',
  },
  'pack-empty-chapter': {
    fix: 'Put a level below the heading in pack.json, or remove it.',
  },
  'unreadable-file': {
    fix: 'Make the file readable, or leave it out of the paths that are checked.',
  },
  crashed: {
    fix: 'Please report it, with the level file and the message.',
  },
};

/** Explanations of the problems that only a check can find. */
export const CHECK_CODES = explainCodes(ADVICE, { longestRun: '--max-time', mostWork: '--max-work' });
