import type { Command } from 'commander';
import { Failure } from './io/index.ts';

/** An option that has an effect only together with another. */
export interface Dependence {
  /** Its long name: `--seed`. */
  readonly option: string;
  /** Whether it has an effect. */
  readonly isUsed: boolean;
  /** The options of which one is needed: `--solve`. */
  readonly needs: string;
}

/** @throws Failure if an option was given that has no effect: the user expects one */
export function refuseUnused(command: Command, dependences: readonly Dependence[]): void {
  for (const { option, isUsed, needs } of dependences) {
    if (isUsed || !isGiven(command, option)) continue;
    throw new Failure(`${option} has no effect without ${needs}: give ${needs} as well, or leave ${option} out`);
  }
}

function isGiven(command: Command, name: string): boolean {
  const option = command.options.find(({ long }) => long === name);
  if (option === undefined) throw new Error(`${command.name()} has no option ${name}`);
  return command.getOptionValueSource(option.attributeName()) === 'cli';
}
