import { makePlugin } from 'gravity-quest-toolkit/phaser/plugin';

/** What something is answered that is not Phaser. */
export function trial(_text: string): string {
  try {
    // @ts-expect-error: the types are known, and this is not Phaser
    return `a plugin ${makePlugin({ VERSION: '2.6.2' }).name}`;
  } catch (error) {
    return error instanceof TypeError ? error.message : 'another error';
  }
}
