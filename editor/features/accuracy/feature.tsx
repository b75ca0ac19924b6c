import { Gauge } from 'lucide-react';
import { laterPanel } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import { OtherAccuracy } from './OtherAccuracy.tsx';
import './accuracy.css';

/** At which accuracy the level is shown, and what each costs and changes. */
export const accuracy: Feature = {
  name: 'accuracy',
  panel: {
    id: 'accuracy',
    title: 'Accuracy',
    icon: <Gauge size={17} />,
    side: 'right',
    place: 'tab',
    content: laterPanel(() => import('./AccuracyPanel.tsx').then(({ AccuracyPanel }) => AccuracyPanel)),
  },
  status: OtherAccuracy,
};
