import { COLOURS, type DrawnPart } from '../../canvas/index.ts';
import type { Command } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { choosePlayFolder, choosePlays, openPlayFiles, openPlays, readingOf } from '../../core/plays/index.ts';
import { type DeathMap, playsInText, shelfOf } from '../../core/shelf/index.ts';
import type { Feature } from '../feature.ts';
import { DeathLayer, DeathLegend, DeathTip } from './Deaths.tsx';
import { followPlayLinks, takeLinkedPlay } from './play-links.ts';

const drawn: DrawnPart<DeathMap | null> = {
  pictureOf({ session }, level) {
    const { store } = shelfOf(level);
    return () => (session.getState().layers.deaths ? store.getState().deaths : null);
  },
  draw: (scene, theme) => new DeathLayer(scene, COLOURS[theme]),
};

/** Recorded plays: opened, verified, shared, and where their players fail. */
export const plays: Feature = {
  name: 'plays',
  layers: [{ id: 'deaths', title: 'heat map of deaths', isShown: true }],
  canvas: { drawn, legend: DeathLegend, cards: DeathTip },
  commands: playsCommands,
  arrive(page) {
    const linked = takeLinkedPlay(page);
    return (editor) => followPlayLinks(editor, linked);
  },
};

/** Opens the plays on the clipboard. */
async function pastePlays(editor: Editor): Promise<void> {
  let text: string;
  try {
    text = await navigator.clipboard.readText();
  } catch {
    editor.notices.show('warning', 'The browser does not let this page read the clipboard.', { topic: 'clipboard' });
    return;
  }
  if (text.trim() === '') {
    editor.notices.show('warning', 'The clipboard has no text. Copy the text of a play or a link to one first.', {
      topic: 'clipboard',
    });
    return;
  }
  const { plays, refused } = playsInText(text, 'the clipboard');
  await openPlays(editor, plays, { refused });
}

/** Commands that open and close plays. */
function playsCommands(editor: Editor): readonly Command[] {
  const { open, notices } = editor;
  const choose = async (chosen: Promise<readonly File[] | null>) => {
    const files = await chosen;
    if (files === null) return;
    if (files.length > 0) await openPlayFiles(editor, files);
    else notices.show('warning', 'This folder has no play: expected files whose names end in .gqr.', { topic: 'plays' });
  };
  const needsPlays = () => {
    const level = open.getState();
    return level === null || shelfOf(level).store.getState().plays.length === 0 ? 'open plays first' : null;
  };
  return [
    { id: 'plays.open', title: 'Open plays…', group: 'Play', run: () => void choose(choosePlays()) },
    { id: 'plays.open-folder', title: 'Open a folder of plays…', group: 'Play', run: () => void choose(choosePlayFolder()) },
    { id: 'plays.paste', title: 'Open the play on the clipboard', group: 'Play', run: () => void pastePlays(editor) },
    {
      id: 'plays.close',
      title: 'Close all opened plays',
      group: 'Play',
      needs: needsPlays,
      run: () => {
        // what is being verified would count together with the plays that are closed now
        readingOf(editor).getState()?.cancel();
        const level = open.getState();
        if (level !== null) shelfOf(level).clear();
      },
    },
  ];
}
