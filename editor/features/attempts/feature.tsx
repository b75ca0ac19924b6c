import { History } from 'lucide-react';
import { perLevel } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { AttemptsPanel } from './AttemptsPanel.tsx';
import { AttemptsWatch } from './AttemptsWatch.tsx';

/** What was tried: own attempts and opened plays, and where they fail. */
export const attempts: Feature = {
  name: 'attempts',
  panel: {
    id: 'attempts',
    title: 'Attempts',
    icon: <History size={17} />,
    side: 'left',
    place: 'tab',
    content: perLevel(AttemptsPanel),
  },
  watch: AttemptsWatch,
};
