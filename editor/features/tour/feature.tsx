import type { Feature } from '../feature.ts';
import './tour.css';
import { useState } from 'react';
import { useStore } from 'zustand';
import { useEditor, useSession } from '../../core/context/index.ts';
import { laterPart } from '../../core/panel/index.ts';

/** A tour of the whole editor in under a minute. */
export const tour: Feature = {
  name: 'tour',
  dialogs: Tour,
  commands: ({ session }) => [
    { id: 'help.tour', title: 'Take the tour', group: 'Help', run: () => session.setState({ overlay: 'tour' }) },
  ],
};

const TourCard = laterPart(() => import('./TourCard.tsx').then((there) => there.TourCard));

/** The tour of the editor, which starts by itself the first time. The page stays usable; Esc ends the tour. */
function Tour() {
  const editor = useEditor();
  const { session, settings } = editor;
  const overlay = useSession((state) => state.overlay);
  const hasLevel = useStore(editor.open, (level) => level !== null);
  const isPlaying = useSession((state) => state.mode === 'play');
  const seen = useStore(settings, (state) => state.tourSeen);
  const isAsked = overlay === 'tour';
  // The tour resumes at the same step after a dialog.
  const [index, setIndex] = useState(0);
  if (!hasLevel || isPlaying || !(isAsked || (!seen && overlay === null))) return null;
  const end = () => {
    setIndex(0);
    settings.setState({ tourSeen: true });
    if (isAsked) session.setState({ overlay: null });
  };
  return <TourCard index={index} onIndex={setIndex} takesFocus={isAsked} onEnd={end} />;
}
