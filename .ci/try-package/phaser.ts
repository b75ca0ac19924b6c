import { createRunner, type Runner, type RunnerOptions } from 'gravity-quest-toolkit/phaser';

/** What a scene that is none is answered: the module works without Phaser, and says what it needs. */
export function trial(_text: string): string {
  const options: RunnerOptions = { restartAfter: null };
  try {
    // @ts-expect-error: the types are known, and this is no scene
    const runner: Runner = createRunner({}, null, options);
    return `a runner ${runner.paused}`;
  } catch (error) {
    return error instanceof TypeError ? error.message : 'another error';
  }
}
