import type { RandomScene } from '../scenes/random-scene.ts';
import type { Finding } from './check-scene.ts';
import { judgeScene } from './judge-scene.ts';
import { checkParts } from './parts.ts';
import { shrinkScene } from './shrink-scene.ts';

/**
 * Holds the engine against the reference in a scene, and whole runs against those in parts. A scene whose end the reference does
 * not decide is `excluded`.
 * @param seed - chooses the parts
 */
export function checkMixed(scene: RandomScene, seed: number): Finding[] {
  const { bugs, excluded } = judgeScene(scene);
  return [
    ...[...bugs, ...checkParts(scene, seed)].map((bug) => ({ kind: 'bug' as const, ...bug })),
    ...(excluded === null ? [] : [{ kind: 'excluded' as const, accuracy: 'precise', what: excluded }]),
  ];
}

/** A smaller scene with the same fault: at the same accuracy, in the same words but for numbers. */
export function shrinkMixed(scene: RandomScene, seed: number, { accuracy, what }: Finding): RandomScene {
  const words = (text: string) => text.replace(/-?\d[\d.e+-]*/g, '#');
  return shrinkScene(scene, (smaller) =>
    checkMixed(smaller, seed).some(
      (found) => found.kind === 'bug' && found.accuracy === accuracy && words(found.what) === words(what),
    ),
  );
}
