import type { Scene } from 'phaser';
import type { Scene as Compiled } from '../engine/index.ts';
import type { Level } from '../schema/basics/index.ts';
import { createRunner, type Runner, type RunnerOptions, requirePhaser } from './runner/index.ts';

// biome-ignore lint/suspicious/noExplicitAny: each version of Phaser has types of its own
type AnyClass = new (...parts: any[]) => any;

/** What {@link makePlugin} needs of Phaser, whichever version it is. */
export interface PhaserLike {
  /** Such as `4.2.1`. */
  readonly VERSION: string;
  /** The namespace of plugins. */
  readonly Plugins: {
    readonly ScenePlugin: AnyClass;
  };
}

/** The plugin of a scene: `this.gravityQuest` under the usual mapping. */
export interface GravityQuestPlugin {
  /** The runners of the scene that are in use. */
  readonly runners: readonly Runner[];
  /**
   * Plays a level in the scene; see {@link createRunner}.
   *
   * @param level - a level, or a scene that `compile` made of one
   * @param options - how it looks, what plays it, and what is told of it
   * @returns the runner
   */
  run(level: Level | Compiled, options?: RunnerOptions): Runner;
}

/** A class for the game's configuration, or for `load.scenePlugin`. */
export type PluginClass = new (...parts: ConstructorParameters<AnyClass>) => GravityQuestPlugin;

/**
 * Makes a scene plugin for the Phaser that is given.
 *
 * @param Phaser - Phaser 3.90 to 4.x, as imported or from its script tag
 * @returns the class of the plugin, for the game's configuration
 * @throws {TypeError} when it is not a supported Phaser
 *
 * @example
 * ```ts
 * new Phaser.Game({
 *   plugins: { scene: [{ key: 'gravityQuest', plugin: makePlugin(Phaser), mapping: 'gravityQuest' }] },
 *   scene: Play,
 * });
 * ```
 */
export function makePlugin(Phaser: PhaserLike | { readonly default: PhaserLike }): PluginClass {
  // a namespace of a CommonJS build has it all under `default`
  const found = (Phaser as Partial<PhaserLike> | undefined)?.VERSION === undefined ? defaultOf(Phaser) : Phaser;
  requirePhaser('makePlugin', found);
  const { ScenePlugin } = (found as PhaserLike).Plugins;
  return class extends ScenePlugin implements GravityQuestPlugin {
    private all: Runner[] = [];

    get runners(): readonly Runner[] {
      this.all = this.all.filter((runner) => !runner.destroyed);
      return this.all;
    }

    run(level: Level | Compiled, options?: RunnerOptions): Runner {
      const { scene } = this as unknown as { readonly scene: Scene };
      const runner = createRunner(scene, level, options);
      this.all.push(runner);
      return runner;
    }
  };
}

const defaultOf = (module: unknown): unknown => (module as { readonly default?: unknown } | undefined)?.default ?? module;
