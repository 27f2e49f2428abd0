// placeholder until the store arrives
