import { COLOURS, type DrawnPart } from '../../canvas/index.ts';
import type { Feature } from '../feature.ts';
import { OnionCard, OnionLabel, onionSessionOf } from './OnionCard.tsx';
import { OnionLayer } from './onion-layer.ts';
import { type OnionPicture, onionPictureOf } from './onion-picture.ts';
import { COMPARE_KEY, onionOf } from './watch-onion.ts';

const drawn: DrawnPart<OnionPicture | null> = {
  pictureOf({ session }, level) {
    const { document } = level;
    const compared = onionOf(level);
    // the same for all frames between two moves of the pointer
    let made: { readonly former: object; readonly file: object; readonly picture: OnionPicture } | null = null;
    return () => {
      const { former } = compared.getState();
      if (former === null || session.getState().mode === 'play') return null;
      const file = document.file();
      if (made?.former !== former || made.file !== file) made = { former, file, picture: onionPictureOf(former, file) };
      return made.picture;
    };
  },
  draw: (scene, theme) => new OnionLayer(scene, COLOURS[theme]),
};

/** The run before and after a change: its former way, and the card with what is better and worse. */
export const onion: Feature = {
  name: 'onion',
  layers: [{ id: 'onion', title: 'run before and after a change', isShown: true }],
  canvas: { drawn, labels: OnionLabel, cards: OnionCard },
  levelCommands(editor, level) {
    const { needs, toggle } = onionSessionOf(editor, level);
    return [
      {
        id: 'view.before',
        title: 'Compare with before the last change',
        group: 'View',
        keys: [COMPARE_KEY],
        needs,
        run: toggle,
      },
    ];
  },
};
