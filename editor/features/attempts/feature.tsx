import { History } from 'lucide-react';
import { perLevel } from '../../core/context/index.ts';
import { laterPanel } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import { AttemptsWatch } from './selected-ghosts.ts';
import './attempts.css';

/** What was tried: own attempts and opened plays, and where they fail. */
export const attempts: Feature = {
  name: 'attempts',
  panel: {
    id: 'attempts',
    title: 'Attempts',
    icon: <History size={17} />,
    side: 'left',
    place: 'tab',
    content: perLevel(laterPanel(() => import('./AttemptsPanel.tsx').then(({ AttemptsPanel }) => AttemptsPanel))),
  },
  watch: AttemptsWatch,
};
