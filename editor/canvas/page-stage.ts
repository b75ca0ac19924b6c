import type { Editor } from '../core/context/index.ts';
import type { DrawnPart } from './part.ts';
import { type ChosenRenderer, chooseRenderer, offersWebgl } from './renderer.ts';
import { createStage, type Stage } from './stage.ts';

interface PageStage {
  readonly stage: Stage;
  readonly renderer: ChosenRenderer;
}

/** one stage per editor, for as long as the page lives */
const stages = new WeakMap<Editor, PageStage>();

/**
 * The stage of the page, created when the first level is shown. Shows a notice if it can't use the requested renderer.
 * @param drawn what features of the page draw; the same at every call
 */
export function stageOf(editor: Editor, drawn: readonly DrawnPart[]): Stage {
  const known = stages.get(editor);
  if (known !== undefined) return known.stage;
  const { settings, notices } = editor;
  const renderer = chooseRenderer(settings.getState().renderer, window.location.search, (need) => offersWebgl(document, need));
  if (renderer.complaint !== null) notices.show('warning', renderer.complaint, { topic: 'renderer' });
  const stage = createStage(renderer.name, drawn);
  stages.set(editor, { stage, renderer });
  return stage;
}

/** The renderer of this page; null before anything is drawn. */
export const rendererOf = (editor: Editor): ChosenRenderer | null => stages.get(editor)?.renderer ?? null;
