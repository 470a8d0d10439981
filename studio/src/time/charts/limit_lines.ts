// Lines across a chart, for comparison with its values.

export interface Limit {
  value: number;
  label: string;
  colour: string;
}

export const symmetricLimits = (value: number, label: string, colour: string): Limit[] => [
  { value, label, colour },
  { value: -value, label, colour },
];
