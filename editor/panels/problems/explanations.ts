import { WARNING_CODES } from '../../../engine/index.ts';
import { CODES } from '../../../schema/index.ts';

/** What a code means and what to do about it. */
interface Explanation {
  readonly code: string;
  readonly title: string;
  readonly why: string;
  readonly fix: string;
}

/** What only the live proof tells, in the words of somebody who sees the level. */
const OF_THE_PROOF: readonly Explanation[] = [
  {
    code: 'no-run',
    title: 'the level has no run',
    why: 'Without a run that completes it nothing shows that a player can complete the level: it is unproven.',
    fix: 'Play it and make an attempt the proof, let the solver find a run, or draw one in the gun lane.',
  },
  {
    code: 'run-does-not-complete',
    title: 'a run does not end in the black hole',
    why: 'A run is the proof that a level can be completed. When none completes it, nobody knows a way through.',
    fix: 'Move what is in the way, change the holds in the gun lane, or take the run out.',
  },
  {
    code: 'verdict-hangs-on-accuracy',
    title: 'the run completes the level at some accuracies and not at others',
    why: 'She passes something so closely that how exactly the motion is simulated decides how the run ends. A player, whose hand is less exact, would hardly succeed that way.',
    fix: 'See the near misses on the way and give her more room there. The accuracy panel has what each setting makes of it.',
  },
];

/** What only a page knows that has the level open. */
const OF_THE_FILE: readonly Explanation[] = [
  {
    code: 'file-unreadable',
    title: 'the file on the disk is no valid level now',
    why: 'Another program has written something into the file that can not be read as a level. `gq check` would call it invalid. The page keeps the last good state and writes nothing over the file.',
    fix: 'Mend the file where the place says: once it can be read, the page goes on by itself. Or write what is on the screen over it.',
  },
  {
    code: 'file-deleted',
    title: 'the file was deleted or moved on the disk',
    why: 'The level is on the screen and kept in this browser, and has no file.',
    fix: 'Write it again, save it as a new level, or let it go.',
  },
];

/** What a worker proves on the side. */
const OF_PROOFS: readonly Explanation[] = [
  {
    code: 'proved-impossible',
    title: 'nobody can complete the level',
    why: 'It is proved that no way of pressing and releasing leads to the black hole. The proof holds for the game at this accuracy, rounding included, and a separate small checker has confirmed it.',
    fix: 'Move what the reason names. Solve draws the proof on the canvas.',
  },
  {
    code: 'mineral-never-collectable',
    title: 'nobody can collect a mineral',
    why: 'It is proved, as for the black hole, that no run touches this mineral: "all minerals" can never be achieved in this level.',
    fix: 'Move the mineral, or what keeps her from it.',
  },
];

const ALL = new Map(
  [...CODES, ...WARNING_CODES, ...OF_THE_PROOF, ...OF_THE_FILE, ...OF_PROOFS].map((explanation) => [
    explanation.code,
    explanation,
  ]),
);

/** What a code means; null for one that is not known. */
export const explanationOf = (code: string): Explanation | null => ALL.get(code) ?? null;
