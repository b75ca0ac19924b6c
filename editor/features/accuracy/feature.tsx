import { Gauge } from 'lucide-react';
import type { Feature } from '../feature.ts';
import { AccuracyPanel } from './AccuracyPanel.tsx';
import { OtherAccuracy } from './OtherAccuracy.tsx';

/** At which accuracy the level is shown, and what each costs and changes. */
export const accuracy: Feature = {
  name: 'accuracy',
  panel: {
    id: 'accuracy',
    title: 'Accuracy',
    icon: <Gauge size={17} />,
    side: 'right',
    place: 'tab',
    content: AccuracyPanel,
  },
  status: OtherAccuracy,
};
