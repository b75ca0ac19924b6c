import type { CodeExplanation } from '../../schema/index.ts';

/** The problems that only checking a level can show. */
export const CHECK_CODES: readonly CodeExplanation[] = [
  {
    code: 'run-does-not-complete',
    severity: 'error',
    title: 'a scripted run does not end in the black hole',
    why:
      'A run is the proof that a level can be completed. When none of them completes it the level is broken: nobody knows a way ' +
      'through. Beside a run that does complete it this is a warning: the failing one proves nothing.',
    fix:
      'Look at what happens with `gq simulate LEVEL --run NAME` or `gq render LEVEL --run NAME -o run.svg`, then move what is in ' +
      'the way, change the holds, or take the run out.',
  },
  {
    code: 'no-run',
    severity: 'error',
    title: 'the level has no run',
    why: 'Without a run that completes it nothing shows that a player can complete the level: it is unproven, and `gq check` is not green.',
    fix: 'Add a run that completes it: a name, and the ticks (1/60 s) in which the gun is held, [press, release).',
    example: '"runs": [\n  { "name": "solution", "holds": [[12, 96], [130, 188]] }\n]',
  },
  {
    code: 'unreadable-file',
    severity: 'error',
    title: 'a file or directory can not be read',
    why: 'A level that was not read was not checked. The check ends with exit code 2, so that nobody takes it for a pass.',
    fix: 'Make the file readable, or leave it out of the paths that are checked.',
  },
  {
    code: 'crashed',
    severity: 'error',
    title: 'gq failed on this level',
    why: 'This is a bug in gq, not in the level: every input should end in a verdict.',
    fix: 'Please report it with the level file and the message.',
  },
];
