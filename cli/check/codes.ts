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
    code: 'verdict-hangs-on-accuracy',
    severity: 'warning',
    title: 'a run completes the level at some accuracies and not at others',
    why:
      'She passes something deadly, a change of target or the edge of the range so closely that how exactly the motion is simulated ' +
      'decides how the run ends. A player, whose hand is less exact than any of these, would hardly succeed that way. Under `arcade`, ' +
      "the original's frames, runs differ most: what was found there often doesn't hold in continuous time, and the other way round. " +
      'A run that fails everywhere, in whatever ways, is not reported.',
    fix:
      'Look at what each accuracy makes of it with `gq accuracy LEVEL --run NAME`, and at where it is close with `gq simulate LEVEL ' +
      '--run NAME` (its clearance). Give her more room there, or find a run that keeps away. If the level is only ever played at ' +
      'one accuracy, check it with that one.',
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
