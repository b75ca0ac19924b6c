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
    fix:
      'Let one be found with `gq solve LEVEL --write`, or add one: a name, and the ticks (1/60 s) in which the gun is held, ' +
      '[press, release). `gq check --solve` searches without writing.',
    example: '"runs": [\n  { "name": "solution", "holds": [[12, 96], [130, 188]] }\n]',
  },
  {
    code: 'found-run',
    severity: 'warning',
    title: 'the level is completable, but not by a run of its own',
    why:
      '`gq check --solve` found a run where no scripted one completes the level. It was replayed from the start, so the level can be ' +
      'completed; but the next check has to search again, and a search with another seed or budget may not find it.',
    fix: 'Keep it: `gq solve LEVEL --write` finds a run, the one that forgives most, and puts it into the file.',
  },
  {
    code: 'no-run-found',
    severity: 'error',
    title: 'a search found neither a run nor a proof that there is none',
    why:
      'Nothing is known: the level may be impossible, or very hard. The message says how much was tried and how near it came; that ' +
      'is no proof. A level that nobody can show to be completable should not be shipped.',
    fix:
      'Draw the nearest with `gq render LEVEL --holds ... -o near.svg`, or where the search has been with `gq render LEVEL ' +
      '--explored -o explored.svg`. Make the level easier, or search longer with `gq solve LEVEL --budget 60`.',
  },
  {
    code: 'proved-impossible',
    severity: 'error',
    title: 'nobody can complete the level',
    why:
      'It is proved that no way of pressing and releasing leads to the black hole: out of range of everything reachable, enclosed by ' +
      'what is deadly, bound to a line, and the like. The proof is rigorous for the game at this accuracy, rounding included, for ' +
      'runs as long as --max-time, and a separate small checker has confirmed its certificate.',
    fix:
      'The message says what to move. `gq render LEVEL --proof -o proof.svg` draws it, `gq solve LEVEL --format json` has the ' +
      'certificate.',
  },
  {
    code: 'mineral-never-collectable',
    severity: 'warning',
    title: 'nobody can collect a mineral',
    why:
      'It is proved, as for the black hole, that no run touches this mineral: "all minerals" can never be achieved in this level. ' +
      'It takes up to a tenth of a second a level, so of more than 64 files at once it is looked for with --solve only.',
    fix: 'Move the mineral, or what keeps her from it, as the message says.',
  },
  {
    code: 'low-slack',
    severity: 'warning',
    title: 'a run forgives nothing',
    why:
      'Presses and releases that come one tick (1/60 s) too early or too late can make it fail: every combination was tried. People ' +
      'are off by 30 ms and more, so this run shows that the level can be completed, hardly that somebody will. It is looked for by ' +
      '`gq check --solve` and `--require-slack` alone, since it takes long.',
    fix:
      'Give her more room where `gq difficulty LEVEL` shows the smallest window, or take a run that forgives more: `gq solve LEVEL` ' +
      'looks for the one that forgives most.',
  },
  {
    code: 'slack-below-required',
    severity: 'error',
    title: 'a run forgives less than --require-slack asks for',
    why:
      '`gq check --require-slack K` asks that every run that completes a level still does when all its presses and releases are off by ' +
      'up to K ticks (1/60 s), in every combination. The message has a combination that fails. The verdict stays: the level is completable.',
    fix:
      'Give her more room where `gq difficulty LEVEL` shows the smallest window, replace the run by one that forgives more (`gq solve ' +
      'LEVEL`), or ask for less.',
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
    code: 'work-limit',
    severity: 'error',
    title: 'the level costs more work than allowed',
    why:
      'Levels may come from strangers, and a valid one can be made to take hours: thousands of aliens awake, orbits of a thousandth of a ' +
      'pixel, runs of a thousand presses. So work is counted, in pieces of motion and what takes as long as one, and memory of recordings ' +
      'in bytes; the count is the same on every machine. Past --max-work a level whose runs were not played to the end is unproven. ' +
      'Where a run has completed it the verdict stays, and this is a warning of what was left out.',
    fix:
      'The message says what ran out, and where. Take out what the level does not need, or the runs that prove nothing; or allow more ' +
      'with `gq check --max-work N` where you know the level. The default lets the check of any file end within seconds.',
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
