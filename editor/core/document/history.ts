import type { LevelFile } from '../../../schema/index.ts';
import { diffFiles, type Patch } from './patch.ts';

interface Step {
  readonly label: string;
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
}

/** The steps that led to a level, and those that were undone. Steps are only added at the end. */
export class History {
  private readonly steps: Step[] = [];
  private count = 0;

  /** The number of steps done. */
  get done(): number {
    return this.count;
  }

  get length(): number {
    return this.steps.length;
  }

  get undoLabel(): string | null {
    return this.count > 0 ? this.steps[this.count - 1].label : null;
  }

  get redoLabel(): string | null {
    return this.count < this.steps.length ? this.steps[this.count].label : null;
  }

  /** The labels of all steps, oldest first. */
  labels(): string[] {
    return this.steps.map(({ label }) => label);
  }

  /** Adds a step and discards the undone ones. @param patches from `before` to `after` */
  record(label: string, before: LevelFile, after: LevelFile, patches: readonly Patch[]): void {
    this.steps.length = this.count;
    this.steps.push({ label, patches, inverse: diffFiles(after, before) });
    this.count++;
  }

  /** Whether the last step may be extended: there is one, and nothing was undone after it. */
  get mayGrow(): boolean {
    return this.count === this.steps.length && this.count > 0;
  }

  /** Replaces the last step by one from `before` to `after`. */
  recordAgain(label: string, before: LevelFile, after: LevelFile): void {
    this.count--;
    this.record(label, before, after, diffFiles(before, after));
  }

  /** Undoes or redoes a step. @returns its label and the patches to apply; null if there is none */
  go(kind: 'undo' | 'redo'): { readonly label: string; readonly patches: readonly Patch[] } | null {
    const step = this.steps[kind === 'undo' ? this.count - 1 : this.count];
    if (step === undefined) return null;
    this.count += kind === 'undo' ? -1 : 1;
    return { label: step.label, patches: kind === 'undo' ? step.inverse : step.patches };
  }
}
