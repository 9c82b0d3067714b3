! It works in degree of freedom mode, with an equation for each coordinate of node m that is eliminated: JTYPE is its
! number. The nodes of the terms are m, whose eliminated coordinate comes first, m again with the coordinate that
! is kept, then node 1 and node n, {dim} times each; JDOF says which degree of freedom of its node a term has, or 0.
! Nodes 1 and n are at X + U. X of m is 0, and every component of its U the coordinate that is kept, so that UE is
! the eliminated coordinate. Derivatives are -A(k)/A(1).
---
    subroutine ask()
        integer, parameter :: dim = {dim}, n = 2 + 2 * dim, mdof = 1, maxdof = 6, nt = 1, nf = 1
        real(dp) :: ue(mdof), a(n), x0(6, n), u(maxdof, n), uinit(maxdof, n), time(2), temp(nt, n), field(nf, nt, n)
        real(dp) :: tran(3, 3, n)
        integer :: jdof(n), ltran(n), jtype, equation, lmpc, kstep, kinc, term
        ! Behind which input the position of a term's node stands; that of m is not given.
        integer, parameter :: behind(n) = [(0, term=1, 2 + dim), (dim, term=1, dim)]
        external :: mpc
        do equation = 1, outputs
            ue = 0
            a = 0
            jdof = 0
            jtype = equation
            x0 = 0
            u = 0
            u(1:dim, 1:2) = x(inputs)
            do term = 3, n
                x0(1:dim, term) = x(behind(term) + 1:behind(term) + dim) / 2
                u(1:dim, term) = x(behind(term) + 1:behind(term) + dim) - x0(1:dim, term)
            end do
            uinit = 0
            lmpc = 1
            kstep = 1
            kinc = 1
            time = 1
            temp = 0
            field = 0
            ltran = 0
            tran = 0
            call mpc(ue, a, jdof, mdof, n, jtype, x0, u, uinit, maxdof, lmpc, kstep, kinc, time, nt, nf, temp, field, &
                ltran, tran)
            if (any(jdof < 0 .or. jdof > dim)) error stop 'JDOF is no degree of freedom of the line'
            y(equation) = ue(1)
            jacobian(equation, :) = 0
            jacobian(equation, inputs) = -a(2) / a(1)
            do term = 3, n
                if (jdof(term) == 0) cycle
                column = behind(term) + jdof(term)
                jacobian(equation, column) = jacobian(equation, column) - a(term) / a(1)
            end do
        end do
    end subroutine ask
