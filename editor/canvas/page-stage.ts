import type { Editor } from '../context/index.ts';
import { type ChosenRenderer, chooseRenderer, offersWebgl } from './renderer.ts';
import { createStage, type Stage } from './stage.ts';

interface PageStage {
  readonly stage: Stage;
  readonly renderer: ChosenRenderer;
}

/** One for the editor of the page, as long as it lives. */
const stages = new WeakMap<Editor, PageStage>();

/** The one stage of the page, set up when the first level is shown. Says so when it can't be what was asked for. */
export function stageOf(editor: Editor): Stage {
  const known = stages.get(editor);
  if (known !== undefined) return known.stage;
  const { settings, notices } = editor;
  const renderer = chooseRenderer(settings.getState().renderer, window.location.search, (need) => offersWebgl(document, need));
  if (renderer.complaint !== null) notices.show('warning', renderer.complaint, { topic: 'renderer' });
  const stage = createStage(renderer.name);
  stages.set(editor, { stage, renderer });
  return stage;
}

/** What draws the canvas of this page; null before anything is drawn. */
export const rendererOf = (editor: Editor): ChosenRenderer | null => stages.get(editor)?.renderer ?? null;
